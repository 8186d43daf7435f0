#include "measure/ground_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <new>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "effort.hpp"
#include "measure/allocations.hpp"
#include "measure/ground_limits.hpp"
#include "measure/ground_models.hpp"
#include "measure/ground_report.hpp"
#include "measure/ground_views.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

SceneDocument blue() { return {find_preset("blue")->scene, "blue"}; }

GroundPlan small_plan() {
  GroundPlan plan;
  plan.width = 240;
  plan.height = 135;
  plan.altitudes = {1e4};
  plan.targets = {0.5, 1.0};
  return plan;
}

GroundRow sample() {
  GroundRow row;
  row.scene = "blue";
  row.model = "quadtree";
  row.altitude = 1e4;
  row.target = 1.0;
  row.pixel_error = 0.5;
  row.measured.places = 1000;
  row.measured.seen = {0.1, 0.9, 3.0};
  row.measured.ground = {50, 1000, 40'000, 200, 9'000};
  row.measured.seen_triangles = 49'000;
  row.measured.look_ms = 0.4;
  row.measured.choose_ms = 0.5;
  return row;
}

std::string broken_of(const GroundRow& row) {
  std::string all;
  for (const std::string& sentence : broken_limits({{}, {}, 0.0, {row}})) all += sentence + "\n";
  return all;
}

TEST(Allocations, AreCounted) {
  const std::int64_t before = allocations();
  ::operator delete(::operator new(8));  // by name, as others may be left out by a compiler
  ::operator delete (::operator new (64, std::align_val_t{64}), std::align_val_t{64});
  EXPECT_EQ(allocations() - before, 2);
}

TEST(GroundModels, AreDrawnAsAskedFor) {
  ASSERT_FALSE(ground_models().empty());
  for (const Ground model : ground_models())
    EXPECT_EQ(ground_technique(with_ground(find_preset("temperate")->scene, model)), model);
}

TEST(GroundViews, AreAsHighAboveGroundAsTheySay) {
  for (const char* const name : {"blue", "highlands", "giant"}) {
    for (const double altitude : measured_altitudes()) {
      const Scene scene = seen_from({find_preset(name)->scene, name}, altitude);
      const Pose pose = pose_of(scene, View());
      EXPECT_NEAR(pose.clearance * scene.planet.radius, altitude, 1e-3 * altitude) << name << " " << altitude;
      EXPECT_GT(surface_radius(scene, direction_of(scene.camera.latitude, scene.camera.longitude)),
                1.0 + scene.water.level / scene.planet.radius)
          << name;
      EXPECT_FALSE(pose.raised);
    }
  }
}

TEST(GroundTable, KeepsItsTargetsWithTheCheapestThatDo) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  const GroundTable table = measure_grounds({blue()}, small_plan(), [](const char*, double) {});
  ASSERT_EQ(table.rows.size(), 2 * ground_models().size());
  const GroundRow &fine = table.rows[0], &coarse = table.rows[1];
  EXPECT_TRUE(fine.reaches_target()) << fine.measured.seen.p99;
  EXPECT_TRUE(coarse.reaches_target()) << coarse.measured.seen.p99;
  EXPECT_LE(fine.pixel_error, coarse.pixel_error);
  EXPECT_GT(fine.measured.ground.triangles, coarse.measured.ground.triangles);
  // A setting that is a step coarser would not.
  Scene scene = with_ground(seen_from(blue(), 1e4), ground_models().front());
  scene.quality.pixel_error = 1.2 * fine.pixel_error;
  View view;
  view.width = small_plan().width;
  view.height = small_plan().height;
  EXPECT_GT(measured_ground(scene, view).seen.p99, fine.target);
}

TEST(GroundTable, ChoosesWithoutAllocations) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  View view;
  view.width = small_plan().width;
  view.height = small_plan().height;
  for (const double altitude : {10.0, 1e5, 1e7})
    EXPECT_EQ(measured_ground(seen_from(blue(), altitude), view).allocations, 0) << altitude;
}

TEST(GroundFlight, ItsRowTellsOfTheMiddleFrameAndOfTheWorst) {
  std::vector<FlightFrame> frames(10, {1e3, 2.0, true});
  frames[3] = {500.0, 5.0, false};
  const FlightRow row = flight_row("blue", Ground::quadtree, frames);
  EXPECT_EQ(row.model, "quadtree");
  EXPECT_EQ(row.median_ms, 2.0);
  EXPECT_EQ(row.worst_ms, 5.0);
  EXPECT_EQ(row.worst_at, 500.0);
  EXPECT_DOUBLE_EQ(row.longer, 0.1);
  EXPECT_DOUBLE_EQ(row.incomplete, 0.1);
}

TEST(GroundLimits, AreBrokenOneByOne) {
  EXPECT_EQ(broken_of(sample()), "");
  GroundRow row = sample();
  row.measured.seen.p99 = 1.1;
  EXPECT_EQ(broken_of(row), "quadtree, blue from 10000 m at 1 px: 99 of 100 places are off by 1.1 px.\n");
  row = sample();
  row.measured.choose_ms = 0.7;
  EXPECT_EQ(broken_of(row), "quadtree, blue from 10000 m at 1 px: 1.1 ms to choose nodes, more than 1.\n");
  row = sample();
  row.measured.allocations = 2;
  EXPECT_EQ(broken_of(row), "quadtree, blue from 10000 m at 1 px: 2 allocations to choose nodes.\n");
  row = sample();
  row.measured.lacking = 3;
  EXPECT_EQ(broken_of(row), "quadtree, blue from 10000 m at 1 px: no room for 3 nodes.\n");
  row = sample();
  row.measured.places = 0;
  EXPECT_EQ(broken_of(row), "quadtree, blue from 10000 m at 1 px: no ground is seen.\n");
  row = sample();
  row.measured.seen_triangles = 210'000;
  EXPECT_EQ(broken_of(row),
            "quadtree, blue from 10000 m at 1 px: 210000 visible triangles, more than 200000.\n"
            "The best of all models, blue from 10000 m at 1 px: 210000 visible triangles, more than 50000.\n");
  row = sample();
  row.target = 2.0;
  EXPECT_EQ(broken_of(row),
            "The best of all models, blue from 10000 m at 2 px: 49000 visible triangles, more than 13000.\n");
}

TEST(GroundLimits, AskOfTheBestModelAlone) {
  GroundRow other = sample();
  other.model = "another";
  other.measured.seen_triangles = 100'000;
  EXPECT_TRUE(broken_limits({{}, {}, 0.0, {other, sample()}}).empty());
  EXPECT_TRUE(broken_limits({{}, {}, 0.0, {sample(), other}}).empty());
  other.altitude = 1e5;  // of another view it is the only one
  EXPECT_EQ(broken_limits({{}, {}, 0.0, {sample(), other}}).size(), 1U);
}

TEST(GroundReport, TellsAllThatWasMeasured) {
  GroundRow row = sample();
  row.frame_ms = Spread{12.0, 11.0, 13.0};
  const GroundTable table = {{}, "a <driver>", 3.0, {sample(), row}};
  const auto json = nlohmann::json::parse(ground_json(table));
  EXPECT_EQ(json["size"], (nlohmann::json{1920, 1080}));
  EXPECT_EQ(json["rows"].size(), 2U);
  EXPECT_EQ(json["rows"][0]["error_px"]["p99"], 0.9);
  EXPECT_EQ(json["rows"][0]["ground"]["skirt_triangles"], 9000);
  EXPECT_FALSE(json["rows"][0].contains("frame_ms"));
  EXPECT_EQ(json["rows"][1]["frame_ms"]["p90"], 13.0);
  EXPECT_TRUE(json["broken"].empty());
  const std::string page = ground_page(table);
  EXPECT_NE(page.find("a &lt;driver&gt;"), std::string::npos);
  EXPECT_NE(page.find(">40000<"), std::string::npos);
  EXPECT_EQ(page.find("class=\"wrong\""), std::string::npos);
  row.measured.lacking = 1;
  EXPECT_NE(ground_page({{}, {}, 0.0, {row}}).find("class=\"wrong\""), std::string::npos);
}

TEST(GroundReport, IsOneTableWithARowForEach) {
  const std::string text = ground_markdown({{}, {}, 0.0, {sample(), sample()}});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
  EXPECT_NE(text.find("| blue  | 10000       | quadtree |"), std::string::npos) << text;
}

}  // namespace
}  // namespace terrella
