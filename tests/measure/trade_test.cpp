// The trade from end to end, on a scene that costs little.
#include "measure/trade.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "effort.hpp"
#include "measure/against.hpp"
#include "measure/counters.hpp"
#include "measure/studio.hpp"
#include "measure/trade_json.hpp"
#include "measure/trade_page.hpp"
#include "measure/trade_path.hpp"
#include "scene/quality_path.hpp"

namespace terrella {
namespace {

// Bare hills under a starless sky.
SceneDocument plain_document() {
  SceneDocument document;
  Scene& scene = document.scene;
  scene.water.model = scene.clouds.model = scene.stars.model = 0;
  scene.lights.density = 0.0;
  scene.terrain.octaves = 6;
  scene.quality.ground_texels = 64;
  return document;
}

TradePlan small_plan() {
  TradePlan plan = trade_plan(true);
  plan.width = test::sanitized ? 32 : 64;
  plan.height = test::sanitized ? 18 : 36;
  plan.rounds = 2;
  return plan;
}

class Trade : public testing::Test {
 protected:
  // Measured once for all of these tests.
  static void SetUpTestSuite() {
    const test::Studio studio;
    report_ = new TradeReport(measure_trade(plain_document(), small_plan(), [](const char*, double) {}));
  }
  static void TearDownTestSuite() { delete report_; }

  static const TradeReport& report() { return *report_; }

 private:
  static inline TradeReport* report_ = nullptr;
};

TEST_F(Trade, MeasuresEverySettingByEveryCamera) {
  ASSERT_GE(report().cameras.size(), 2U);
  ASSERT_LT(report().own, report().settings.size());
  EXPECT_EQ(report().settings[report().own].scene, plain_document().scene);
  for (const Setting& setting : report().settings) {
    ASSERT_EQ(setting.sightings.size(), report().cameras.size());
    EXPECT_EQ(setting.id, setting_id(setting.scene));
    const Spread ms = setting.ms();
    EXPECT_GT(ms.p10, 0.0);
    EXPECT_LE(ms.p10, ms.median);
    EXPECT_LE(ms.median, ms.p90);
    EXPECT_GT(setting.error().psnr(), 5.0);
    EXPECT_LT(setting.error().psnr(), 80.0);
    const std::vector<double> work = setting.work();
    ASSERT_EQ(work.size(), counters().size());
    for (std::size_t i = 0; i < work.size(); ++i) EXPECT_GE(work[i], 0.0) << counters()[i].name;
  }
}

TEST_F(Trade, TurnsEachKnobByItself) {
  const auto mattering = std::count_if(knobs().begin(), knobs().end(),
                                       [](const Knob& knob) { return knob.matters(report().document.scene); });
  ASSERT_EQ(std::ssize(report().knobs), mattering);
  for (const KnobTrade& trade : report().knobs) {
    ASSERT_EQ(trade.values.size(), trade.settings.size());
    for (std::size_t i = 0; i < trade.values.size(); ++i) {
      const Scene expected = turned(plain_document().scene, *trade.knob, trade.values[i]);
      EXPECT_EQ(report().settings[trade.settings[i]].scene, expected);
    }
  }
}

TEST_F(Trade, WalksFromAllCheapestToAllFinest) {
  Scene cheapest = plain_document().scene, finest = cheapest;
  for (const KnobTrade& trade : report().knobs) {
    cheapest = turned(cheapest, *trade.knob, trade.values.front());
    finest = turned(finest, *trade.knob, trade.values.back());
  }
  EXPECT_EQ(report().estimates.front().id, setting_id(cheapest));
  EXPECT_EQ(report().estimates.back().id, setting_id(finest));
  for (const Scene& end : {cheapest, finest}) {
    const auto is_end = [&](const Setting& setting) { return setting.scene == end; };
    EXPECT_TRUE(std::any_of(report().settings.begin(), report().settings.end(), is_end));
  }
}

TEST_F(Trade, LeavesOutOnlyWhatTheSceneHas) {
  std::vector<std::string> names;
  for (const EffectTrade& trade : report().effects) names.emplace_back(trade.effect->name);
  EXPECT_EQ(names, (std::vector<std::string>{"air", "hollows", "sun", "antialias"}));
  // Without its air, the picture is farther from the one that has it.
  EXPECT_LT(report().effects[0].without.error().psnr(), report().settings[report().own].error().psnr() - 1.0);
}

TEST_F(Trade, IsTheSameAsItsJsonSays) {
  const std::string text = trade_json(report());
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json["schema"], trade_schema);
  EXPECT_EQ(json["settings"].size(), report().settings.size());
  EXPECT_EQ(json["own"], report().settings[report().own].id);
  EXPECT_EQ(json["front"].size(), report().front.size());
  EXPECT_EQ(json["machine"]["size"], (nlohmann::json{report().plan.width, report().plan.height}));
  for (const auto& setting : json["settings"]) {
    EXPECT_EQ(setting["parameters"].size(), report().knobs.size());
    EXPECT_EQ(setting["cameras"].size(), report().cameras.size());
    EXPECT_GT(setting["psnr"], 0.0);
  }
  const Result<TradeSummary> read = read_trade(text);
  ASSERT_TRUE(read) << read.sentence();
  EXPECT_EQ(why_not_comparable(*read, to_be_measured(report().document, report().plan)), "");
  const Comparison comparison = compare(*read, *read);
  EXPECT_EQ(static_cast<std::size_t>(comparison.compared), report().settings.size());
  EXPECT_TRUE(comparison.worse.empty());
}

TEST_F(Trade, IsAPageThatAsksNothingOfAnyHost) {
  Comparison comparison;
  comparison.worse = {"a <setting> is slower."};
  const std::string page = trade_page(report(), comparison);
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_NE(page.find("data:image/png;base64,iVBOR"), std::string::npos);
  EXPECT_NE(page.find("a &lt;setting&gt; is slower."), std::string::npos);
  EXPECT_TRUE(page.ends_with("</html>\n"));
  for (const char* foreign : {"http:", "https:", "<script", "@import", "url(", "<link", ">nan", ">inf"})
    EXPECT_EQ(page.find(foreign), std::string::npos) << foreign;
  for (std::size_t at = page.find("src="); at != std::string::npos; at = page.find("src=", at + 1))
    EXPECT_EQ(page.compare(at, 10, "src=\"data:"), 0);
}

// As the program reads it: rising, with names that are known, and settings that a link can hold.
TEST_F(Trade, ItsPathIsOneThatTheProgramCanWalk) {
  TradeReport report = this->report();
  // So small pictures all take about as long: as if the more accurate had taken longer.
  std::vector<double> errors;
  for (const Setting& setting : report.settings) errors.push_back(setting.error().mean_square);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const auto less_accurate = std::count_if(errors.begin(), errors.end(), [&](double e) { return e > errors[i]; });
    for (Sighting& sighting : report.settings[i].sightings)
      std::fill(sighting.times.begin(), sighting.times.end(), std::pow(1.2, static_cast<double>(less_accurate)));
  }
  draw_conclusions(report);
  const std::vector<std::size_t> steps = walked_settings(report);
  ASSERT_GE(steps.size(), 2U);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    EXPECT_GT(report.settings[steps[i]].ms().median, report.settings[steps[i - 1]].ms().median);
    EXPECT_GT(report.settings[steps[i]].error().psnr(), report.settings[steps[i - 1]].error().psnr());
  }
  for (const QualityPreset& preset : report.presets)
    EXPECT_TRUE(std::find(steps.begin(), steps.end(), preset.setting) != steps.end()) << preset.name;
  const std::string text = path_inc(report);
  EXPECT_NE(text.find("STEP(\"\", 1, "), std::string::npos) << text;
  EXPECT_NE(text.find("STEP(\"reference\", "), std::string::npos) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3 + 2 * std::ssize(steps)) << text;
}

TEST(TradeOfThePath, MeasuresTheProgramsStepsAndNothingElse) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  const test::Studio studio;
  TradePlan plan = small_plan();
  plan.path_only = true;
  const TradeReport report = measure_trade(plain_document(), plan, [](const char*, double) {});
  ASSERT_EQ(report.steps.size(), quality_path().size());
  for (std::size_t i = 0; i < report.steps.size(); ++i)
    EXPECT_TRUE(has_quality(report.settings[report.steps[i]].scene, quality_path()[i]));
  EXPECT_LE(report.settings.size(), quality_path().size() + 1);
  EXPECT_FALSE(trade_page(report, std::nullopt).empty());
  const std::string table = path_table(report);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3 + std::ssize(report.steps)) << table;
}

}  // namespace
}  // namespace terrella
