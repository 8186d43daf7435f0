#include "scene/json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "random_scene.hpp"

namespace terrella {
namespace {

struct Loaded {
  SceneDocument document;
  std::vector<std::string> sentences;
};

Loaded load(std::string_view json) {
  Loaded loaded;
  loaded.sentences = load_json(loaded.document, json).sentences();
  return loaded;
}

using Sentences = std::vector<std::string>;

TEST(ToJson, HoldsOnlyWhatDiffersFromThePreset) {
  EXPECT_EQ(to_json({}), R"({"terrella":1})");
  const Preset* storm = find_preset("storm");
  SceneDocument document{storm->scene, storm->name};
  EXPECT_EQ(to_json(document), R"({"terrella":1,"preset":"storm"})");
  document.scene.waves.steepness = 0.9;
  document.scene.sun.color = {255, 136, 0};
  document.scene.terrain.ridged = !document.scene.terrain.ridged;
  EXPECT_EQ(nlohmann::json::parse(to_json(document)),
            nlohmann::json::parse(R"({"terrella": 1, "preset": "storm", "waves": {"steepness": 0.9},
                                      "sun": {"color": "#ff8800"}, "terrain": {"ridged": false}})"));
}

TEST(Json, RoundTripsRandomScenes) {
  Random random(42);
  for (int i = 0; i < 1000; ++i) {
    const SceneDocument document = random_document(random);
    const std::string json = to_json(document);
    const Loaded loaded = load(json);
    ASSERT_EQ(loaded.sentences, Sentences{}) << json;
    ASSERT_EQ(loaded.document, document) << json;
    ASSERT_EQ(to_json(loaded.document), json);
    ASSERT_TRUE(nlohmann::json::accept(json)) << json;
  }
}

TEST(LoadJson, StartsFromThePresetWhereverItStands) {
  const Loaded before = load(R"({"preset": "storm", "waves": {"count": 3}})");
  const Loaded after = load(R"({"waves": {"count": 3}, "preset": "storm"})");
  EXPECT_EQ(before.document, after.document);
  EXPECT_EQ(before.document.preset, "storm");
  EXPECT_EQ(before.document.scene.waves.count, 3);
  EXPECT_EQ(before.document.scene.water, find_preset("storm")->scene.water);
}

TEST(LoadJson, WithoutAPresetAddsToWhatThereIs) {
  SceneDocument document{find_preset("storm")->scene, "storm"};
  EXPECT_TRUE(load_json(document, R"({"waves.count": 3})").empty());
  EXPECT_EQ(document.preset, "storm");
  EXPECT_EQ(document.scene.waves.count, 3);
}

TEST(LoadJson, SaysEachThingThatIsWrongAndAppliesTheRest) {
  const Loaded loaded = load(R"({"terrella": 2, "preset": "strom", "title": "mine",
    "waves": {"count": 8, "steepness": 1.4, "speed": NaN, "length": 1e999, "amplitude": "high", "spread": null},
    "wavs": {"count": 3}, "sun": 5, "water": {"model": "lava"}, "terrain": {"ridged": 1}, "air": {"color": "#ff88"},
    "clouds": {"octaves": 3, "octaves": 4}})");
  EXPECT_EQ(loaded.sentences, (Sentences{
                                  "terrella: version 2 is not known; this program reads version 1.",
                                  "preset: there is no preset \"strom\"; did you mean storm?",
                                  "waves.steepness: 1.4 is out of range; allowed are 0 to 1.",
                                  "waves.speed: NaN is not a number; allowed are 0 to 1e6 m/s.",
                                  "waves.length: 1e999 is out of range; allowed are 1e-6 to 1e8 m.",
                                  "waves.amplitude: \"high\" is not a number; allowed are 0 to 1e8 m.",
                                  "waves.spread: null is not a number; allowed are 0 to 1.",
                                  "wavs.count: there is no such parameter; did you mean waves.count?",
                                  "sun: 5 is not a group of parameters, {…}.",
                                  "water.model: \"lava\" is not a choice; allowed are none, auto, calm, waves.",
                                  "terrain.ridged: 1 is neither true nor false; allowed are true or false.",
                                  "air.color: \"#ff88\" is not a colour; allowed are #000000 to #ffffff.",
                                  "clouds.octaves: is given more than once; the last one counts.",
                              }));
  SceneDocument expected;
  expected.scene.waves.count = 8;
  expected.scene.clouds.octaves = 4;
  EXPECT_EQ(loaded.document, expected);
}

TEST(LoadJson, ReadsWhatStandsBeforeABreak) {
  const Loaded loaded = load(R"({"terrella": 1, "waves": {"count": 8, "seed": 1)");
  ASSERT_EQ(loaded.sentences.size(), 1u);
  EXPECT_EQ(loaded.sentences[0], "Line 1, column 48: the text breaks off; the rest was not read.");
  EXPECT_EQ(loaded.document.scene.waves.count, 8);
}

TEST(LoadJson, RepairsWhatIsNotUtf8) {
  const Loaded loaded = load("{\"title\": \"\xe4\", \"waves\": {\"count\": 8}}");
  EXPECT_EQ(loaded.sentences, Sentences{"The scene is not UTF-8 text from byte 12 on."});
  EXPECT_EQ(loaded.document.scene.waves.count, 8);
}

TEST(LoadJson, RefusesWhatIsTooLong) {
  const Loaded loaded = load("{\"waves\":{\"count\":8}}" + std::string(10'000'000, ' '));
  EXPECT_EQ(loaded.sentences, Sentences{"The scene is 10000021 bytes long; at most 1000000 are read."});
  EXPECT_EQ(loaded.document, SceneDocument{});
}

TEST(LoadJson, ListsTheFirstTwentyOfAThousandMistakes) {
  std::string json = "{\"waves.count\":8";
  for (int i = 0; i < 1000; ++i) json += ",\"wrong" + std::to_string(i) + "\":1";
  const Loaded loaded = load(json + "}");
  ASSERT_EQ(loaded.sentences.size(), 21u);
  EXPECT_EQ(loaded.sentences.back(), "and 980 more.");
  EXPECT_EQ(loaded.document.scene.waves.count, 8);
}

TEST(LoadJson, BearsTheWorstThatFits) {
  const auto repeated = [](const std::string& piece, const std::string& end) {
    std::string json = "{";
    while (json.size() + piece.size() + end.size() < kLongestJson) json += piece;
    return json + end;
  };
  for (const std::string& json :
       {repeated("\"wavs.count\":1,", "\"a\":1}"),      // each deserves a search for its nearest name
        repeated("\"preset\":\"stom\",", "\"a\":1}"),   // so does each of these
        repeated("\"preset\":\"storm\",", "\"a\":1}"),  // each a new start
        repeated("\"sun.color\":1e999,", "\"a\":1}"),   // each a number too large
        repeated("\"a\":[", ""), repeated("\"a\":{", ""), repeated("\\", "")}) {
    EXPECT_FALSE(load(json).sentences.empty());
  }
}

}  // namespace
}  // namespace terrella
