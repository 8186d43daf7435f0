#include "planet/terrain.hpp"

#include <gtest/gtest.h>

#include <array>

#include "laws/random_places.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

TEST(HeightsAt, AreThoseOfEachFootprint) {
  test::Places places(8);
  for (const char* preset : {"blue", "craters", "frozen", "alps"}) {
    const f64::Terrain terrain = exact_terrain_of(find_preset(preset)->scene);
    for (int n = 0; n < 300; ++n) {
      const glm::dvec3 direction = places.on_sphere();
      const double finest = std::pow(10.0, places.between(-8.0, 0.0));
      const std::array<double, 3> footprints = {finest, 2.0 * finest, 40.0 * finest};
      std::array<f64::Height, 3> heights;
      heights_at(direction, terrain, footprints, heights);
      for (std::size_t k = 0; k < heights.size(); ++k) {
        const f64::Height expected = f64::terrain_height_at(direction, terrain, footprints[k]);
        const f64::Height& found = heights[k];
        EXPECT_NEAR(found.value, expected.value, 1e-15);
        EXPECT_NEAR(found.mean, expected.mean, 1e-14);
        EXPECT_NEAR(found.shape, expected.shape, 1e-14);
        EXPECT_NEAR(found.openness, expected.openness, 1e-12);
        EXPECT_EQ(found.iced, expected.iced);
        EXPECT_LE(glm::distance(found.gradient, expected.gradient), 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace terrella
