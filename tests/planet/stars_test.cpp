#include "planet/stars.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

namespace terrella {
namespace {

TEST(Stars, AreMoreTheHigherTheDensityAndNoneAtNone) {
  std::size_t before = 0;
  for (const double density : {0.0, 0.25, 0.5, 1.0}) {
    Scene scene;
    scene.stars.density = density;
    const std::size_t count = find_stars(scene).stars.size();
    if (density == 0.0) {
      EXPECT_EQ(count, 0U);
    } else {
      EXPECT_GT(count, before);
    }
    before = count;
  }
}

TEST(Stars, LieEverywhereNoneTwice) {
  const StarSky sky = find_stars({});
  glm::dvec3 mean(0.0);
  for (const Star& star : sky.stars) {
    EXPECT_NEAR(glm::length(star.direction), 1.0F, 1e-5F);
    EXPECT_GT(star.brightness, 0.0F);
    EXPECT_LE(star.brightness, 1.0F);
    mean += glm::dvec3(star.direction) / static_cast<double>(sky.stars.size());
  }
  EXPECT_LT(glm::length(mean), 0.1);
  for (std::size_t i = 0; i < sky.stars.size(); ++i) {
    for (std::size_t k = i + 1; k < sky.stars.size(); ++k) {
      ASSERT_GT(glm::distance(sky.stars[i].direction, sky.stars[k].direction), 0.01F);
    }
  }
}

TEST(Stars, DifferInColorAndBrightness) {
  const StarSky sky = find_stars({});
  float bluest = 10.0F, reddest = 0.0F, dimmest = 1.0F, brightest = 0.0F;
  for (const Star& star : sky.stars) {
    bluest = std::fmin(bluest, star.color.r / star.color.b);
    reddest = std::fmax(reddest, star.color.r / star.color.b);
    dimmest = std::fmin(dimmest, star.brightness);
    brightest = std::fmax(brightest, star.brightness);
  }
  EXPECT_LT(bluest, 0.8F);
  EXPECT_GT(reddest, 1.6F);
  EXPECT_GT(brightest, 5.0F * dimmest);
}

}  // namespace
}  // namespace terrella
