// The ground by way of the probe is the ground of a scene: ranges and maps of heights among it.
#include "planet/terrain.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "height_maps.hpp"
#include "probe/probe.hpp"

namespace terrella::probe {
namespace {

Json asked_once(const Json& request) {
  return Json::parse(Probe(nullptr).answer(std::vector<std::string>{request.dump()}).at(0));
}

Scene rough_ground() {
  Scene scene;
  scene.planet.seed = 12;
  scene.water.model = 0;  // and so no ice
  auto& terrain = scene.terrain;
  terrain.height = 0.05 * scene.planet.radius;
  terrain.frequency = 3.0;
  terrain.octaves = 9;
  terrain.persistence = 0.55;
  terrain.lacunarity = 1.9;
  terrain.power = 1.7;
  terrain.ridged = true;
  terrain.ridge_sharpness = 40.0;
  terrain.craters = 0.0;
  return scene;
}

Json layers_of(const Scene& scene) {
  const auto& terrain = scene.terrain;
  return {{"H", terrain.height / scene.planet.radius}, {"frequency", terrain.frequency},   {"octaves", terrain.octaves},
          {"persistence", terrain.persistence},        {"lacunarity", terrain.lacunarity}, {"p", terrain.power},
          {"mode", terrain.ridged ? "ridge" : "fbm"},  {"k", terrain.ridge_sharpness},     {"seed", scene.planet.seed}};
}

Json json_of(const HeightMap& map) {
  const HeightMap::Level& all = map.levels()[0];
  return {{"width", all.width}, {"height", all.height}, {"heights", all.heights}};
}

// At places all over the sphere and for footprints from metres to continents.
void expect_ground_of(const Scene& scene, const char* function, Json args) {
  const f64::Terrain terrain = exact_terrain_of(scene);
  Random random(7U);
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 d = random.on_sphere();
    const double footprint = random.log_between(1e-6, 1.0);
    args["direction"] = {d.x, d.y, d.z};
    args["footprint"] = footprint;
    const Json answer = asked_once({{"fn", function}, {"args", args}});
    ASSERT_TRUE(answer.contains("value")) << answer.dump();
    const f64::Height ground = f64::terrain_height_at(d, terrain, footprint);
    EXPECT_EQ(answer["value"]["height"].get<double>(), ground.value);
    EXPECT_EQ(answer["value"]["openness"].get<double>(), ground.openness);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(answer["value"]["grad"][static_cast<std::size_t>(axis)].get<double>(), ground.gradient[axis]);
    }
  }
}

TEST(ProbedTerrain, IsThatOfAScene) {
  const Scene scene = rough_ground();
  expect_ground_of(scene, "terrain_height", layers_of(scene));
}

TEST(ProbedTerrain, HasRanges) {
  Scene scene = rough_ground();
  scene.terrain.ranges = 0.7;
  scene.terrain.range_layer = 3;
  Json args = layers_of(scene);
  args["ranges"] = {{"part", 0.7}, {"first", 3}};
  expect_ground_of(scene, "terrain_height", args);
  scene.terrain.foothills = 0.2;
  args["ranges"]["low"] = 0.2;
  expect_ground_of(scene, "terrain_height", args);
}

// Making a map smooths it around the poles: what the request holds has been smoothed once and is so again.
SharedHeightMap made_again(const SharedHeightMap& map) {
  const HeightMap::Level& all = map->levels()[0];
  return std::make_shared<const HeightMap>(all.width, all.height, all.heights);
}

TEST(ProbedTerrain, HasAMap) {
  for (const SharedHeightMap& map : {terrella::test::smooth_map(32, 16), terrella::test::rough_map(48, 48, 5U)}) {
    Scene scene = rough_ground();
    scene.terrain.ranges = 0.7;  // which a map has of its own
    scene.terrain.map.map = made_again(map);
    Json args = layers_of(scene);
    args["map"] = json_of(*map);
    expect_ground_of(scene, "mapped_height", args);
  }
}

std::string trouble_with_map(const char* name, const Json& value) {
  const Scene scene = rough_ground();
  Json args = layers_of(scene);
  args["direction"] = {0, 0, 1};
  args["footprint"] = 0.1;
  args["map"] = json_of(*terrella::test::smooth_map(16, 8));
  args["map"][name] = value;
  return asked_once({{"fn", "mapped_height"}, {"args", args}}).value("error", std::string("none"));
}

TEST(ProbedTerrain, SaysWhatIsWrongWithAMap) {
  EXPECT_EQ(trouble_with_map("width", 16), "none");
  EXPECT_EQ(trouble_with_map("width", 17), "map.heights: there are 128 numbers; a map of 17x8 has 136.");
  EXPECT_EQ(trouble_with_map("heights", Json::array({0.5})),
            "map.heights: there are 1 numbers; a map of 16x8 has 128.");
  EXPECT_EQ(
      trouble_with_map("width", 33),
      "map: is 33x8 pixels; allowed is a map of the whole planet that is 8 to 8192 pixels high, and 1 to 4 times as "
      "wide but no wider than 8192; most are twice as wide as high.");
  EXPECT_EQ(trouble_with_map("height", 9000), "height: 9000 is out of range; allowed is 1 to 8192.");
  EXPECT_EQ(trouble_with_map("width", 16.5), "width: 16.5 is not a whole number.");
  EXPECT_EQ(trouble_with_map("heights", Json::array({0.5, 1.5})),
            "heights[1]: 1.5 is out of range; allowed is 0 to 1.");
  EXPECT_EQ(trouble_with_map("heights", Json::array({0.5, "high"})), "heights[1]: \"high\" is not a number.");
}

TEST(ProbedTerrain, MapsAreAsLargeAsARequest) {
  const Scene scene = rough_ground();
  Json args = layers_of(scene);
  args["direction"] = {0, 1, 0};
  args["footprint"] = 0.1;
  args["map"] = {{"width", 250}, {"height", 200}, {"heights", std::vector<double>(50'000, 0.25)}};
  for (const char* precision : {"f64", "f32"}) {
    const Json answer = asked_once({{"fn", "mapped_height"}, {"args", args}, {"precision", precision}});
    EXPECT_TRUE(answer.contains("value")) << answer.dump();
  }
  args["map"]["width"] = 400;
  EXPECT_EQ(asked_once({{"fn", "mapped_height"}, {"args", args}})["error"],
            "map.heights: there are 50000 numbers; a map of 400x200 has 80000, but a request holds at most 50000.");
}

}  // namespace
}  // namespace terrella::probe
