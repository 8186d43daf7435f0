#include "native/options.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/file.hpp"
#include "base/image.hpp"
#include "scene/json.hpp"
#include "scene/presets.hpp"
#include "scene/quality_path.hpp"

namespace terrella {
namespace {

// The scene that a command line asks for.
SceneChoice parse(std::vector<std::string> arguments) {
  CLI::App command;
  SceneOptions options;
  add_scene_options(command, options);
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
  command.parse(arguments);
  return choose_scene(options);
}

std::string scene_file(std::string_view json) {
  const std::string path = testing::TempDir() + "terrella_options_test.json";
  EXPECT_TRUE(write_file_whole(path, json));
  return path;
}

TEST(SceneOptions, WithoutAnyGiveTheDefault) {
  const SceneChoice choice = parse({});
  EXPECT_TRUE(choice.issues.empty());
  EXPECT_EQ(choice.document, SceneDocument{});
}

TEST(SceneOptions, ApplyInTheirOrderHoweverTheyAreGiven) {
  const std::string file = scene_file(R"({"waves": {"count": 1, "seed": 1, "speed": 1}})");
  const SceneChoice choice = parse({"--set", "waves.speed=3", "--link", "?waves.seed=2&waves.speed=2",
                                    "--set=waves.spread=0.5", "--scene", file, "--preset", "storm"});
  EXPECT_EQ(choice.issues.sentences(), std::vector<std::string>{});
  SceneDocument expected{find_preset("storm")->scene, "storm"};
  expected.scene.waves.count = 1;
  expected.scene.waves.seed = 2;
  expected.scene.waves.speed = 3;
  expected.scene.waves.spread = 0.5;
  EXPECT_EQ(choice.document, expected);
}

TEST(SceneOptions, TakeAPresetOfQualityBeforeTheSettings) {
  const Scene scene =
      parse({"--set", "quality.antialias=true", "--quality", "fast", "--preset", "storm"}).document.scene;
  Scene expected = with_quality(find_preset("storm")->scene, *find_quality("fast"));
  expected.quality.antialias = true;
  EXPECT_EQ(scene, expected);
  EXPECT_EQ(parse({"--quality", "best"}).issues.count(), 1u);
}

TEST(SceneOptions, ReadTheMapThatASceneNamesBesideItsFile) {
  Image map(32, 16, 1);
  ASSERT_TRUE(write_file_whole(testing::TempDir() + "terrella_options_map.pfm", encode_pfm(map)));
  const std::string file = scene_file(R"({"terrain": {"map": "terrella_options_map.pfm"}})");
  const SceneChoice beside = parse({"--scene", file});
  EXPECT_EQ(beside.issues.sentences(), std::vector<std::string>{});
  EXPECT_EQ(beside.document.scene.terrain.map.name, "terrella_options_map.pfm");
  ASSERT_TRUE(beside.document.scene.terrain.map.map);
  EXPECT_EQ(beside.document.scene.terrain.map.map->highest(), 0.0F);
  EXPECT_TRUE(parse({"--set", "terrain.map=" + testing::TempDir() + "terrella_options_map.pfm"}).issues.empty());
}

TEST(SceneOptions, SayWhatIsWrongWithAMap) {
  EXPECT_EQ(parse({"--set", "terrain.map=nowhere.png"}).issues.sentences(),
            std::vector<std::string>{"terrain.map: nowhere.png: cannot be read: No such file or directory."});
  const std::string file = scene_file("{}");
  EXPECT_EQ(parse({"--set", "terrain.map=" + file}).issues.sentences(),
            std::vector<std::string>{"terrain.map: " + file +
                                     ": is neither a PNG nor a portable float map (PFM), by its first bytes."});
  EXPECT_EQ(parse({"--set", "terrain.map=" + std::string(201, 'a')}).issues.count(), 1U);
}

TEST(SceneOptions, TakeNegativeNumbers) {
  EXPECT_EQ(parse({"--set", "camera.pitch=-45.5"}).document.scene.camera.pitch, -45.5);
}

TEST(SceneOptions, SayAllThatIsWrong) {
  const SceneChoice choice = parse({"--preset", "", "--scene", "/no/such/file.json", "--link", "wavs.count=3", "--set",
                                    "waves.steepness=2", "--set", "nonsense"});
  EXPECT_EQ(choice.issues.sentences(), (std::vector<std::string>{
                                           "preset: there is no preset \"\".",
                                           "/no/such/file.json: cannot be read: No such file or directory.",
                                           "wavs.count: there is no such parameter; did you mean waves.count?",
                                           "waves.steepness: 2 is out of range; allowed are 0 to 1.",
                                           "--set \"nonsense\" is not of the form group.name=value.",
                                       }));
}

TEST(SceneOptions, RefuseAFileThatIsTooLong) {
  const SceneChoice choice = parse({"--scene", scene_file("{}" + std::string(kLongestJson, ' '))});
  ASSERT_EQ(choice.issues.count(), 1u);
  EXPECT_NE(choice.issues.sentences()[0].find("longer than the 1000000 bytes"), std::string::npos);
}

}  // namespace
}  // namespace terrella
