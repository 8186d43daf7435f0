#include "planet/milky_band.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

namespace terrella {
namespace {

TEST(MilkyBand, HasDimStarsAroundAGreatCircle) {
  const Scene scene;
  const StarSky sky = find_band_stars(scene);
  const glm::vec3 normal(milky_band_normal(scene));
  EXPECT_NEAR(glm::length(normal), 1.0F, 1e-6F);
  glm::dvec3 mean(0.0);
  for (const Star& star : sky.stars) {
    ASSERT_NEAR(glm::length(star.direction), 1.0F, 1e-5F);
    ASSERT_LT(std::abs(glm::dot(star.direction, normal)), 0.2F);
    ASSERT_GE(star.brightness, 0.0F);
    ASSERT_LT(star.brightness, 0.2F);  // dim beside the others
    mean += glm::dvec3(star.direction) / static_cast<double>(sky.stars.size());
  }
  EXPECT_GT(sky.stars.size(), 1000U);
  EXPECT_LT(glm::length(mean), 0.25);  // all the way around
}

TEST(MilkyBand, GlowsInABeltWithoutAGap) {
  const Scene scene;
  const BandGlow glow = find_band_glow(scene);
  const glm::vec3 normal(milky_band_normal(scene));
  for (const glm::vec3& vertex : glow.vertices) {
    const float bright = glm::length(vertex) - 1.0F;
    ASSERT_GE(bright, -1e-6F);
    ASSERT_LE(bright, 1.0F);
    // Dark at its edges, so that they are not seen.
    if (std::abs(glm::dot(vertex, normal)) / (1.0F + bright) > 0.199F) {
      ASSERT_NEAR(bright, 0.0F, 1e-6F);
    }
  }
  // Each edge of a triangle is another's as well, but for those where it ends, which nobody sees.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  ASSERT_EQ(glow.indices.size() % 6, 0U);
  for (std::size_t i = 0; i < glow.indices.size(); ++i) {
    const std::uint32_t a = glow.indices[i], b = glow.indices[i % 3 == 2 ? i - 2 : i + 1];
    ++uses[std::minmax(a, b)];
    const glm::vec3 from = glm::normalize(glow.vertices[a]), to = glm::normalize(glow.vertices[b]);
    ASSERT_LT(glm::distance(from, to), band_square);
  }
  for (const auto& [edge, times] : uses) {
    const bool rim =
        glm::length(glow.vertices[edge.first]) < 1.004F && glm::length(glow.vertices[edge.second]) < 1.004F;
    ASSERT_TRUE(times == 2 || (times == 1 && rim));
  }
}

TEST(MilkyBand, GrowsWithItsParameterFromNothing) {
  Scene scene;
  scene.stars.band = 0.0;
  EXPECT_TRUE(find_band_stars(scene).stars.empty());
  EXPECT_TRUE(find_band_glow(scene).vertices.empty());
  const auto brightest = [&] {
    float most = 0.0F;
    for (const glm::vec3& vertex : find_band_glow(scene).vertices) most = std::max(most, glm::length(vertex) - 1.0F);
    return most;
  };
  scene.stars.band = 0.3;
  const std::size_t few = find_band_stars(scene).stars.size();
  const float dim = brightest();
  EXPECT_GT(dim, 0.1F);
  scene.stars.band = 1.0;
  EXPECT_GT(find_band_stars(scene).stars.size(), 2 * few);
  EXPECT_NEAR(brightest(), dim / 0.3F, 1e-4F);
}

TEST(MilkyBand, LiesElsewhereInAnotherSky) {
  Scene other;
  other.stars.seed = 2;
  EXPECT_LT(std::abs(glm::dot(milky_band_normal(other), milky_band_normal(Scene{}))), 0.95);
}

}  // namespace
}  // namespace terrella
