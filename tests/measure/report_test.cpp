#include "measure/report.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include <nlohmann/json.hpp>

namespace terrella {
namespace {

ExtremesReport sample() {
  ExtremesReport report;
  report.renderer = "a <driver> & more";
  report.groups = {{"core", "single", 12, 0, 345, 2, 0.05, 67.0}};
  report.limits = {{"sea", "water.level", "m", "px", 0.01, {{1.0, 0.001, false}, {1e4, 0.15, true}}}};
  report.invariances = {{"all lengths times 2", "difference", 0.0, 0.0, 0.3}};
  return report;
}

bool shows(const std::string& page, const std::string& text) { return page.find(text) != std::string::npos; }

TEST(ExtremesReport, HoldsUntilSomethingDoesNot) {
  EXPECT_TRUE(sample().holds());
  ExtremesReport faulty = sample();
  faulty.faults.push_back({"core", "single", "sun.size = 0", "sun.size=0", 64, 36, 0.0, "1 pixel is not finite."});
  EXPECT_FALSE(faulty.holds());
  ExtremesReport silent = sample();
  silent.limits[0].points[1].warned = false;
  EXPECT_FALSE(silent.holds());
  ExtremesReport changed = sample();
  changed.invariances[0].measured = 1e-9;
  EXPECT_FALSE(changed.holds());
  ExtremesReport empty = sample();
  empty.invariances[0].at_stake = 0.0;
  EXPECT_FALSE(empty.holds());
  ExtremesReport boundless = sample();
  boundless.limits[0].points[0].warned = true;  // as all of them are then
  EXPECT_FALSE(boundless.holds());
  ExtremesReport unknown = sample();
  unknown.invariances[0].measured = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(unknown.holds());
  unknown = sample();
  unknown.limits[0].points[0].error = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(unknown.holds());
}

TEST(ExtremesJson, TellsAllThatWasMeasured) {
  ExtremesReport report = sample();
  report.limits[0].points.push_back({1e6, std::numeric_limits<double>::infinity(), true});
  const auto json = nlohmann::json::parse(extremes_json(report));
  EXPECT_EQ(json["renderer"], "a <driver> & more");
  EXPECT_EQ(json["extent"], "quick");
  EXPECT_TRUE(json["holds"]);
  EXPECT_EQ(json["groups"][0]["cases"], 12);
  EXPECT_EQ(json["limits"][0]["path"], "water.level");
  EXPECT_EQ(json["limits"][0]["worst_within"], 0.001);
  EXPECT_EQ(json["limits"][0]["points"][1]["warned"], true);
  EXPECT_TRUE(json["limits"][0]["points"][2]["error"].is_null());
  EXPECT_EQ(json["invariances"][0]["bound"], 0.0);
  EXPECT_EQ(json["invariances"][0]["at_stake"], 0.3);
}

TEST(ExtremesPage, IsWholeAndAsksNothingOfAnyHost) {
  ExtremesReport report = sample();
  EXPECT_TRUE(shows(extremes_page(report), "all holds"));
  report.faults.push_back({"es", "pair", "row 3", "a=1&b=2", 64, 36, 1e9, "3 pixels of light are not finite."});
  const std::string page = extremes_page(report);
  EXPECT_TRUE(shows(page, "a &lt;driver&gt; &amp; more"));
  EXPECT_TRUE(shows(page, "not all holds"));
  EXPECT_TRUE(shows(page, "a=1&amp;b=2 --size 64x36 --time 1e9"));
  EXPECT_TRUE(shows(page, "at 10000"));
  EXPECT_TRUE(shows(page, "</html>"));
  for (const char* foreign : {"http:", "https:", "<script", "src=", "@import"}) EXPECT_FALSE(shows(page, foreign));
}

}  // namespace
}  // namespace terrella
