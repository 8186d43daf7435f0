// `terrella render --path` from the command line to its files.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>

#include "base/file.hpp"
#include "base/text.hpp"
#include "native/cmd_render.hpp"
#include "native/picture_series.hpp"
#include "run_command.hpp"
#include "scene/json.hpp"

namespace terrella {
namespace {

namespace fs = std::filesystem;

using test::Outcome;

Outcome run(const std::string& line) { return test::run_command(add_render_command, line); }

constexpr const char* two_views =
    R"({"terrella_path": 1, "views": [{"altitude": 3}, {"altitude": 0.3, "pitch": -30, "heading": 40, "at": 4}]})";

// A folder with a path in it, gone with its owner.
class PathCommand : public testing::Test {
 protected:
  PathCommand()
      : folder_(fs::path(testing::TempDir()) /
                text_of("terrella_path_", testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    give_path(two_views);
  }
  ~PathCommand() override { fs::remove_all(folder_); }

  std::string in(const std::string& name) const { return (folder_ / name).string(); }
  void give_path(std::string_view text) const { ASSERT_TRUE(write_file_whole(in("way.json"), text)); }

  // A small picture of little, quickly drawn.
  Outcome render(const std::string& options, const std::string& out = "fly.png") const {
    return run(text_of("render --path ", in("way.json"), " --out ", in(out),
                       options.find("--size") == std::string::npos ? " --size 32x18" : "",
                       " --set terrain.octaves=4 --set quality.ground_texels=64 --set quality.cloud_texels=32 ",
                       options));
  }

  // All files but the path, with their bytes.
  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> all;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
      if (entry.path().filename() == "way.json") continue;
      all[entry.path().filename().string()] = *read_file(entry.path().string(), 10'000'000);
    }
    return all;
  }

  const fs::path folder_;
};

TEST_F(PathCommand, WritesANumberedSeries) {
  const Outcome outcome = render("--frames 3");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.said, "");
  const auto written = files();
  ASSERT_EQ(written.size(), 4u);
  for (const char* name : {"fly-0001.png", "fly-0002.png", "fly-0003.png", "fly.series.json"}) {
    EXPECT_TRUE(written.contains(name)) << name;
  }
  EXPECT_NE(written.at("fly-0001.png"), written.at("fly-0002.png"));
  EXPECT_NE(written.at("fly-0002.png"), written.at("fly-0003.png"));
}

// The first picture is that of the first view, the last one that of the last, at the time that has come by then.
TEST_F(PathCommand, BeginsAndEndsWithThePicturesOfItsViews) {
  EXPECT_EQ(render("--frames 2 --time 10 --set time.speed=2").code, 0);
  const std::string scene =
      "--size 32x18 --set terrain.octaves=4 --set quality.ground_texels=64 --set quality.cloud_texels=32 ";
  EXPECT_EQ(
      run(text_of("render --time 10 --set time.speed=2 --set camera.altitude=3 ", scene, "--out ", in("first.png")))
          .code,
      0);
  EXPECT_EQ(run(text_of("render --time 18 --set time.speed=2 --set camera.altitude=0.3 --set camera.pitch=-30 "
                        "--set camera.heading=40 ",
                        scene, "--out ", in("last.png")))
                .code,
            0);
  const auto written = files();
  EXPECT_EQ(written.at("fly-0001.png"), written.at("first.png"));
  EXPECT_EQ(written.at("fly-0002.png"), written.at("last.png"));
}

TEST_F(PathCommand, GoesOnWhereItWasInterrupted) {
  ASSERT_EQ(render("--frames 6").code, 0);
  const auto whole = files();
  fs::remove(in("fly-0002.png"));
  fs::remove(in("fly-0005.png"));
  // What is there stays as it is: were it drawn anew, this time would change.
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1000);
  for (const auto& [name, bytes] : files()) fs::last_write_time(in(name), long_ago);
  const Outcome outcome = render("--frames 6");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.said, "4 of 6 pictures are there already.\n");
  EXPECT_EQ(files(), whole);
  for (const auto& [name, bytes] : files()) {
    const bool anew = name == "fly-0002.png" || name == "fly-0005.png";
    EXPECT_EQ(fs::last_write_time(in(name)) != long_ago, anew) << name;
  }
  EXPECT_EQ(render("--frames 6").said, "6 of 6 pictures are there already.\n");
}

TEST_F(PathCommand, DrawsAnewWhatIsNotWhole) {
  ASSERT_EQ(render("--frames 3").code, 0);
  const auto whole = files();
  fs::resize_file(in("fly-0001.png"), 100);
  std::ofstream(in("fly-0003.png"), std::ios::trunc) << "";
  EXPECT_EQ(render("--frames 3").said, "1 of 3 pictures are there already.\n");
  EXPECT_EQ(files(), whole);
}

TEST_F(PathCommand, MixesNoTwoSeries) {
  ASSERT_EQ(render("--frames 3").code, 0);
  const auto before = files();
  const std::pair<const char*, const char*> cases[] = {
      {"--frames 4", "there \"frames\": 3, now \"frames\": 4"},
      {"--frames 3 --size 16x9", "there \"size\": \"32x18\", now \"size\": \"16x9\""},
      {"--frames 3 --samples 2", "there \"samples\": 1, now \"samples\": 2"},
      {"--frames 3 --transparent", "there \"transparent\": false, now \"transparent\": true"},
      {"--frames 3 --time 1", "there \"time\": 0, now \"time\": 1"},
      {"--frames 3 --seconds 5", "there \"seconds\": 4, now \"seconds\": 5"},
      {"--frames 3 --reference", "there \"drawn_by\": \"core\", now \"drawn_by\": \"reference\""},
      {"--frames 3 --set planet.seed=7", "there \"planet.seed\": 1, now \"planet.seed\": 7"}};
  for (const auto& [options, difference] : cases) {
    const Outcome outcome = render(options);
    EXPECT_EQ(outcome.code, 2) << options;
    EXPECT_EQ(outcome.said,
              text_of(in("fly.series.json"), ": pictures of something else are there already: ", difference,
                      "; give another --out, or delete this file and ", in("fly-*.png"), ".\n"));
  }
  give_path(
      R"({"terrella_path": 1, "views": [{"altitude": 3}, {"altitude": 0.4, "pitch": -30, "heading": 40, "at": 4}]})");
  EXPECT_EQ(render("--frames 3").code, 2);
  EXPECT_EQ(files(), before);
  // The way one puts it does not count, and neither does the camera of the scene, which the views replace.
  give_path(
      R"({"terrella_path": 1, "views": [{"altitude": 3, "pitch": -90}, {"altitude": 3e-1, "pitch": -30, "heading": 40, "at": 4}]})");
  EXPECT_EQ(render("--frames 3 --set camera.pitch=-20").said, "3 of 3 pictures are there already.\n");
}

TEST_F(PathCommand, TouchesNoPicturesThatNobodyTellsOf) {
  std::ofstream(in("fly-0002.png")) << "somebody's";
  const auto before = files();
  const Outcome outcome = render("--frames 3");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.said, text_of(in("fly-0002.png"), ": is there already, and no ", in("fly.series.json"),
                                  " tells what it shows; give another --out, or delete it.\n"));
  EXPECT_EQ(files(), before);
}

TEST_F(PathCommand, MeasuresAndAsksTheReferenceToo) {
  EXPECT_EQ(render("--frames 2 --channel distance --reference --size 8x4", "far.pfm").code, 0);
  EXPECT_EQ(render("--frames 2 --size 8x4", "light.pfm").code, 0);
  const auto whole = files();
  EXPECT_EQ(whole.size(), 6u);
  EXPECT_EQ(whole.at("far-0001.pfm").substr(0, 7), "Pf\n8 4\n");
  fs::resize_file(in("far-0001.pfm"), 60);
  EXPECT_EQ(render("--frames 2 --channel distance --reference --size 8x4", "far.pfm").said,
            "1 of 2 pictures are there already.\n");
  EXPECT_EQ(files(), whole);
}

TEST_F(PathCommand, SaysWhatIsWrongAndWritesNothing) {
  const std::pair<std::string, std::string> cases[] = {
      {"",
       "--frames: must say how many pictures of the path to draw, 1 to 1000000; it takes 4 s, in which 121 are 30 a "
       "second.\n"},
      {"--frames -3 --seconds 1e6", "--frames: must say how many pictures of the path to draw, 1 to 1000000.\n"},
      {"--frames 3 --seconds 0", "--seconds: must be a number over 0, at most 1e9.\n"},
      {"--frames 3 --seconds nan", "--seconds: must be a number over 0, at most 1e9.\n"},
      {"--frames 3 --why", "--why: is for a single picture; leave it out, or leave out --path.\n"},
      {"--frames 3 --stats s.json", "--stats: is for a single picture; leave it out, or leave out --path.\n"},
      {"--frames 3 --set wavs.count=3", "wavs.count: there is no such parameter; did you mean waves.count?\n"}};
  for (const auto& [options, sentence] : cases) {
    const Outcome outcome = render(options);
    EXPECT_EQ(outcome.code, 2) << options;
    EXPECT_EQ(outcome.said, sentence) << options;
  }
  give_path(R"({"terrella_path": 1, "views": [{"altitud": 3}, {"latitude": 91}]})");
  const Outcome outcome = render("--frames 3");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.said,
            "view 1, altitud: there is no such key; allowed are latitude, longitude, altitude, heading, pitch, roll, "
            "fov, at; "
            "did you mean altitude?\n"
            "view 2, latitude: 91 is out of range; allowed are -90 to 90 deg.\n");
  EXPECT_EQ(render("--frames 3", "fly.gif").code, 2);
  fs::remove(in("way.json"));
  const Outcome missing = render("--frames 3");
  EXPECT_EQ(missing.code, 2);
  EXPECT_EQ(missing.said, text_of("--path: ", in("way.json"), ": cannot be read: No such file or directory.\n"));
  EXPECT_TRUE(files().empty());
}

TEST_F(PathCommand, SaysWhereItCannotWrite) {
  const Outcome outcome = render("--frames 3", "no/such/folder/fly.png");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.said.find("cannot be written: No such file or directory."), std::string::npos) << outcome.said;
}

TEST_F(PathCommand, TimesFramesWithoutAPathAsEver) {
  EXPECT_EQ(run(text_of("render --out ", in("one.png"), " --size 32x18 --frames 2 --stats ", in("one.json"))).code, 0);
  EXPECT_EQ(files().size(), 2u);
  EXPECT_NE(files().at("one.json").find("\"frames\":3"), std::string::npos) << files().at("one.json");
  const Outcome outcome = run(text_of("render --seconds 3 --out ", in("two.png")));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.said, "--seconds: is how long the flight along a path takes; give --path as well.\n");
}

// What docs/command_line.md shows.
TEST_F(PathCommand, FliesTheExampleOfTheManual) {
  give_path(*read_file(std::string(TERRELLA_SOURCE_DIR) + "/docs/orbit_to_shore.json", kLongestJson));
  EXPECT_EQ(render("--frames 5").said, "");
  EXPECT_EQ(files().size(), 6u);
}

TEST_F(PathCommand, FliesTheExampleOfAPlanetOfRealSize) {
  give_path(*read_file(std::string(TERRELLA_SOURCE_DIR) + "/docs/to_the_beach.json", kLongestJson));
  EXPECT_EQ(render("--preset blue --frames 5").said, "");
  EXPECT_EQ(files().size(), 6u);
}

// The numbers have as many digits as they need.
TEST(PictureSeries, NumbersItsFilesInTheirOrder) {
  EXPECT_EQ(PictureSeries("a/fly.png", 12, "").file(0), "a/fly-0001.png");
  EXPECT_EQ(PictureSeries("fly.pfm", 9999, "").file(9998), "fly-9999.pfm");
  EXPECT_EQ(PictureSeries("fly.png", 10000, "").file(0), "fly-00001.png");
  EXPECT_EQ(PictureSeries("fly.png", 1000000, "").file(999999), "fly-1000000.png");
}

}  // namespace
}  // namespace terrella
