#include "planet/milky_band.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

namespace terrella {
namespace {

TEST(MilkyBand, LiesAroundAGreatCircleGlowsFirst) {
  const Scene scene;
  const StarSky sky = find_milky_band(scene);
  const glm::vec3 normal = milky_band_normal(scene);
  EXPECT_NEAR(glm::length(normal), 1.0F, 1e-6F);
  std::size_t glows = 0;
  glm::dvec3 mean(0.0);
  for (std::size_t i = 0; i < sky.stars.size(); ++i) {
    const Star& star = sky.stars[i];
    ASSERT_NEAR(glm::length(star.direction), 1.0F, 1e-5F);
    ASSERT_LT(std::abs(glm::dot(star.direction, normal)), 0.2F);
    ASSERT_GE(star.brightness, 0.0F);
    ASSERT_LT(star.brightness, 0.2F);  // dim beside the others
    if (star.radius > 0.0F) {
      ASSERT_EQ(glows, i);
      ++glows;
    }
    mean += glm::dvec3(star.direction) / static_cast<double>(sky.stars.size());
  }
  EXPECT_GT(glows, 300U);
  EXPECT_GT(sky.stars.size(), 3 * glows);
  EXPECT_LT(glm::length(mean), 0.25);  // all the way around
}

TEST(MilkyBand, GrowsWithItsParameterFromNothing) {
  Scene scene;
  scene.stars.band = 0.0;
  EXPECT_TRUE(find_milky_band(scene).stars.empty());
  scene.stars.band = 0.3;
  const std::size_t few = find_milky_band(scene).stars.size();
  scene.stars.band = 1.0;
  EXPECT_GT(find_milky_band(scene).stars.size(), 2 * few);
}

TEST(MilkyBand, LiesElsewhereInAnotherSky) {
  Scene other;
  other.stars.seed = 2;
  EXPECT_LT(std::abs(glm::dot(milky_band_normal(other), milky_band_normal(Scene{}))), 0.95F);
}

}  // namespace
}  // namespace terrella
