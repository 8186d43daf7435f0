#include "planet/lights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "laws/random_places.hpp"
#include "planet/needs.hpp"
#include "planet/terrain.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

Scene lit() {
  Scene scene = find_preset("temperate")->scene;
  scene.lights.density = 0.5;
  return scene;
}

TEST(Lights, StandOnLandOverItsMeshAndNeitherOnRockNorInSnow) {
  const Scene scene = lit();
  const Lights found = find_lights(scene, ground_level(scene));
  ASSERT_GT(found.lights.size(), 500U);
  const f32::Terrain terrain = terrain_of(scene);
  for (const Light& light : found.lights) {
    const double radius = glm::length(light.position);
    const glm::dvec3 up = glm::dvec3(light.position) / radius;
    ASSERT_GT(radius, 1.0 + scene.water.level);
    ASSERT_GT(radius, drawn_ground_radius(terrain, up, ground_level(scene)));
    ASSERT_LT(radius, 1.0 + scene.water.level + scene.terrain.mountain_height + 0.02);
    ASSERT_LT(std::fabs(up.z), 0.93);  // sine of 68 degrees
    ASSERT_GT(light.brightness, 0.0F);
    ASSERT_LE(light.brightness, 1.0F);
  }
}

TEST(Lights, AreAsManyAsAskedForAndTheSameEachTime) {
  Scene scene = lit();
  const Lights some = find_lights(scene, ground_level(scene)), again = find_lights(scene, ground_level(scene));
  ASSERT_EQ(some.lights.size(), again.lights.size());
  EXPECT_EQ(some.lights.back().position, again.lights.back().position);
  scene.lights.density = 1.0;
  EXPECT_NEAR(static_cast<double>(find_lights(scene, ground_level(scene)).lights.size()) /
                  static_cast<double>(some.lights.size()),
              2.0, 0.2);
  scene.lights.density = 0.0;
  EXPECT_TRUE(find_lights(scene, ground_level(scene)).lights.empty());
}

// Spread evenly, so many lights would leave no place on land a tenth of a radius from the next.
TEST(Lights, LeaveWildCountryBetweenTheTowns) {
  const Scene scene = lit();
  const Lights found = find_lights(scene, ground_level(scene));
  const f32::Terrain terrain = terrain_of(scene);
  test::Places places(81U);
  int land = 0, wild = 0;
  while (land < 500) {
    const glm::dvec3 direction = places.on_sphere();
    const double height = ground_radius(terrain, direction, 0.01) - 1.0 - scene.water.level;
    if (height < 0.0 || height > 0.5 * scene.terrain.mountain_height || std::fabs(direction.z) > 0.8) continue;
    ++land;
    const bool near = std::any_of(found.lights.begin(), found.lights.end(), [&](const Light& light) {
      return glm::distance(light.position, glm::vec3(direction)) < 0.12F;
    });
    wild += near ? 0 : 1;
  }
  EXPECT_GT(wild, 35);  // measured 44
}

}  // namespace
}  // namespace terrella
