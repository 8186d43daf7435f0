// The reference on a map of heights.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "height_maps.hpp"
#include "laws/random_places.hpp"
#include "planet/terrain.hpp"
#include "reference/ground.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

Scene on_map(const char* preset, const SharedHeightMap& map) {
  Scene scene = find_preset(preset)->scene;
  scene.terrain.map = {"a", map};
  return scene;
}

TEST(ReferenceOnAMap, BoundsHoldAllHeightsAround) {
  test::Places places(3);
  for (const char* preset : {"blue", "alps", "moon"}) {
    for (const SharedHeightMap& map : {test::rough_map(64, 32, 2), test::smooth_map(256, 128)}) {
      const Scene scene = on_map(preset, map);
      const reference::Ground ground(scene, 1e-4);
      for (int i = 0; i < 300; ++i) {
        const glm::dvec3 d = places.on_sphere();
        const double chord = std::pow(10.0, places.between(-5.0, -0.5));
        const double told_from = places.between(0.0, 1.0) * (ground.highest() - 1.0);
        const reference::Range range = ground.heights_over({d, chord}, {told_from, told_from});
        for (int k = 0; k < 20; ++k) {
          const glm::dvec3 beside = glm::normalize(d + places.in_cube(0.55) * chord);
          const double height = ground.height_at(beside).value;
          ASSERT_GE(height, range.least - 1e-12) << preset << " " << chord;
          ASSERT_LE(height, range.most + 1e-12) << preset << " " << chord;
        }
      }
    }
  }
}

// Camera, reference and mesh stand on the same ground.
TEST(ReferenceOnAMap, IsTheGroundOfEverybody) {
  const Scene scene = on_map("blue", test::smooth_map(256, 128));
  const reference::Ground ground(scene, 1e-3);
  test::Places places(4);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 d = places.on_sphere();
    EXPECT_DOUBLE_EQ(ground.radius_at(d), exact_ground_radius(exact_terrain_of(scene), d, 1e-3));
    EXPECT_NEAR(ground.radius_at(d), ground_radius(terrain_of(scene), d, 1e-3), 1e-5);
  }
}

}  // namespace
}  // namespace terrella
