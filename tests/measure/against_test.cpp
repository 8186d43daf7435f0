#include "measure/against.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

namespace terrella {
namespace {

TradeSummary made_up() {
  TradeSummary summary;
  summary.renderer = "a driver";
  summary.cpu = "a processor";
  summary.timer = "wall";
  summary.size = {64, 36};
  summary.control_ms = {10.0, 9.0, 11.0};
  summary.settings["default"] = {{20.0, 19.0, 22.0}, 34.0};
  summary.settings["quality.antialias=false"] = {{18.0, 17.0, 20.0}, 33.0};
  return summary;
}

Spread times(const Spread& spread, double factor) {
  return {spread.median * factor, spread.p10 * factor, spread.p90 * factor};
}

TEST(Against, FindsNothingWhereNothingChanged) {
  const Comparison comparison = compare(made_up(), made_up());
  EXPECT_EQ(comparison.compared, 2);
  EXPECT_TRUE(comparison.worse.empty());
  EXPECT_TRUE(comparison.better.empty());
}

TEST(Against, TellsWhatIsSlowerBeyondTheNoise) {
  TradeSummary now = made_up();
  now.settings["default"].ms = {26.0, 24.0, 29.0};
  const Comparison comparison = compare(made_up(), now);
  ASSERT_EQ(comparison.worse.size(), 1U);
  EXPECT_EQ(comparison.worse[0],
            "default is slower: 26 ms (24 to 29), after 20 ms (19 to 22), of which 1 times is the machine's.");
  EXPECT_EQ(compare(now, made_up()).better.size(), 1U);
  EXPECT_TRUE(compare(now, made_up()).worse.empty());
}

TEST(Against, TakesNoiseForNoise) {
  TradeSummary now = made_up();
  now.settings["default"].ms = {23.0, 21.5, 30.0};  // begins where the old spread ends
  EXPECT_TRUE(compare(made_up(), now).worse.empty());
}

TEST(Against, KnowsAMachineThatIsSlowerItself) {
  TradeSummary now = made_up();
  now.control_ms = times(now.control_ms, 3.0);
  for (auto& [id, setting] : now.settings) setting.ms = times(setting.ms, 3.0);
  EXPECT_TRUE(compare(made_up(), now).worse.empty());
  EXPECT_TRUE(compare(made_up(), now).better.empty());
  // Nor does a slower machine hide what became slower by more.
  now.settings["default"].ms = times(now.settings["default"].ms, 1.5);
  EXPECT_EQ(compare(made_up(), now).worse.size(), 1U);
}

TEST(Against, TellsWhatIsLessAccurate) {
  TradeSummary now = made_up();
  now.settings["default"].psnr -= 0.2;
  const Comparison comparison = compare(made_up(), now);
  ASSERT_EQ(comparison.worse.size(), 1U);
  EXPECT_EQ(comparison.worse[0], "default is less accurate: 33.8 dB after 34 dB.");
  EXPECT_EQ(compare(now, made_up()).better.size(), 1U);
  now.settings["default"].psnr = 33.99;
  EXPECT_TRUE(compare(made_up(), now).worse.empty());
}

TEST(Against, ComparesNoTimesOfAnotherMachine) {
  TradeSummary now = made_up();
  now.renderer = "another driver";
  now.settings["default"].ms = times(now.settings["default"].ms, 9.0);
  now.settings["default"].psnr -= 0.2;
  const Comparison comparison = compare(made_up(), now);
  EXPECT_TRUE(comparison.worse.empty());
  EXPECT_NE(comparison.about_times.find("another machine"), std::string::npos);
  now.settings["default"].psnr -= 1.0;
  EXPECT_EQ(compare(made_up(), now).worse.size(), 1U);
}

TEST(Against, LeavesOutSettingsThatOnlyOneOfBothHas) {
  TradeSummary before = made_up();
  before.settings.erase("default");
  before.settings["quality.pixel_error=3"] = {};
  EXPECT_EQ(compare(before, made_up()).compared, 1);
}

TEST(Against, SaysWhenTwoReportsAreOfDifferentThings) {
  EXPECT_EQ(why_not_comparable(made_up(), made_up()), "");
  TradeSummary other = made_up();
  other.scene = "{}";
  EXPECT_EQ(why_not_comparable(other, made_up()), "is of another scene.");
  other = made_up();
  other.size = {65, 36};
  EXPECT_EQ(why_not_comparable(other, made_up()), "is of pictures of another size.");
  other = made_up();
  other.cameras = "elsewhere";
  EXPECT_EQ(why_not_comparable(other, made_up()), "is of other cameras.");
  other = made_up();
  other.judged_at = std::nan("");  // a report that does not say
  EXPECT_EQ(why_not_comparable(other, made_up()), "is of another moment.");
}

// A whole report, and what is left of it without one of its members.
TEST(OldTrade, IsReadOrRefusedWithASentence) {
  const auto whole = nlohmann::json::parse(R"({"schema": 1,
    "machine": {"renderer": "a", "cpu": "b", "timer": "wall", "size": [1, 2],
                "control_ms": {"median": 2, "p10": 1, "p90": 3}},
    "scene": {"terrella": 1}, "cameras": [{"name": "own", "scene": {"terrella": 1}}],
    "settings": [{"id": "default", "ms": {"median": 2, "p10": 1, "p90": 3}, "psnr": 30.5}]})");
  const Result<TradeSummary> read = read_trade(whole.dump());
  ASSERT_TRUE(read) << read.sentence();
  EXPECT_EQ(read->settings.at("default").psnr, 30.5);
  EXPECT_EQ(read->settings.at("default").ms.p90, 3.0);
  EXPECT_EQ(read->scene, R"({"terrella":1})");
  for (const char* pointer : {"/schema", "/machine", "/machine/control_ms", "/machine/control_ms/p10", "/settings",
                              "/settings/0/id", "/settings/0/ms", "/settings/0/ms/median", "/settings/0/psnr"}) {
    for (const char* instead : {"null", "[]", "{}", "\"text\"", "-1", "true"}) {
      auto broken = whole;
      broken[nlohmann::json::json_pointer(pointer)] = nlohmann::json::parse(instead);
      const bool negative_psnr = std::string(pointer).ends_with("psnr") && std::string(instead) == "-1";
      const bool text_for_id = std::string(pointer).ends_with("id") && std::string(instead) == "\"text\"";
      EXPECT_EQ(static_cast<bool>(read_trade(broken.dump())), negative_psnr || text_for_id) << pointer << instead;
    }
  }
}

TEST(OldTrade, SurvivesGarbage) {
  const std::string deep = "{\"schema\": 1, \"settings\": " + std::string(200'000, '[');
  std::string closed = deep + std::string(200'000, ']') + "}";
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("\0\xff", 2), std::string("1e999"), deep, closed,
        std::string(R"({"schema": 1e30})"), std::string(R"({"schema": 18446744073709551615})"),
        std::string(R"({"schema": 1, "settings": [1, null, "x", [], {}]})")}) {
    const Result<TradeSummary> read = read_trade(text);
    EXPECT_FALSE(read) << text.substr(0, 40);
    EXPECT_TRUE(read.sentence().ends_with(".")) << read.sentence();
  }
}

}  // namespace
}  // namespace terrella
