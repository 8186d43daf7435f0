#include <gtest/gtest.h>

#include <cmath>

#include "formulas/formulas.hpp"

namespace terrella {
namespace {

constexpr double fine = 1e-4;

TEST(RingMatter, IsWithinItsBoundsAndNoneBeyondItsEdges) {
  double least = 1.0, most = 0.0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    for (int i = 0; i <= 1000; ++i) {
      const double matter = f64::ring_matter(i / 1000.0, fine, seed);
      ASSERT_GE(matter, 0.0);
      ASSERT_LE(matter, 1.0);
      if (i > 50 && i < 950) least = std::fmin(least, matter), most = std::fmax(most, matter);
    }
    EXPECT_EQ(f64::ring_matter(0.0, fine, seed), 0.0);
    EXPECT_EQ(f64::ring_matter(1.0, fine, seed), 0.0);
    EXPECT_EQ(f64::ring_matter(-3.0, fine, seed), 0.0);
    EXPECT_EQ(f64::ring_matter(3.0, fine, seed), 0.0);
  }
  EXPECT_LT(least, 0.05);  // gaps
  EXPECT_GT(most, 0.95);   // and dense ringlets
}

TEST(RingMatter, ChangesLittleBetweenNeighbouringSamples) {
  for (const double footprint : {0.001, 0.01, 0.1}) {
    double largest = 0.0;
    for (double x = 0.1; x < 0.9; x += footprint / 7.0) {
      largest = std::fmax(largest,
                          std::abs(f64::ring_matter(x + footprint, footprint, 3) - f64::ring_matter(x, footprint, 3)));
    }
    EXPECT_LT(largest, 0.75) << footprint;  // measured: 0.16, 0.62, 0.69
  }
}

TEST(RingOpacity, GrowsWithMatterAndWithTheWayThroughIt) {
  EXPECT_EQ(f64::ring_opacity(0.0, 0.9, 1.0), 0.0);
  EXPECT_NEAR(f64::ring_opacity(1.0, 0.9, 1.0), 0.9, 1e-12);
  EXPECT_NEAR(f64::ring_opacity(1.0, 0.9, -0.5), 0.99, 1e-12);  // twice the way
  EXPECT_GT(f64::ring_opacity(0.5, 0.9, 0.3), f64::ring_opacity(0.4, 0.9, 0.3));
  EXPECT_LE(f64::ring_opacity(1.0, 1.0, 0.0), 1.0);
}

TEST(RingShade, FallsOnlyWhereTheWayToTheSunCrossesTheRings) {
  const glm::dvec3 sun = glm::normalize(glm::dvec3(1.0, 0.0, 0.5));
  f64::Rings rings;
  rings.inner = 1.5;
  rings.outer = 2.5;
  rings.density = 1.0;
  rings.seed = 3U;
  const auto shade = [&](const glm::dvec3& place) { return f64::ring_shade(place, sun, rings, fine); };
  EXPECT_EQ(shade(glm::normalize(glm::dvec3(1.0, 0.0, 0.1))), 1.0);  // on the sun's side of them
  EXPECT_EQ(shade({1.0, 0.0, 0.0}), 1.0);
  EXPECT_EQ(shade({0.8, 0.0, -0.2}), 1.0);  // crosses at 1.2, within them
  EXPECT_EQ(shade({0.6, 0.0, -1.0}), 1.0);  // crosses at 2.6, beyond
  double darkest = 1.0;
  for (double z = -0.85; z < -0.4; z += 0.01) darkest = std::fmin(darkest, shade({0.7, 0.0, z}));
  EXPECT_LT(darkest, 0.01);
}

TEST(PlanetShade, IsItsShadowWithASoftEdge) {
  const glm::dvec3 sun(0.0, 1.0, 0.0);
  EXPECT_EQ(f64::planet_shade({0.5, 2.0, 0.0}, sun), 1.0);
  EXPECT_EQ(f64::planet_shade({0.5, -2.0, 0.0}, sun), 0.0);
  EXPECT_EQ(f64::planet_shade({1.5, -2.0, 0.0}, sun), 1.0);
  EXPECT_NEAR(f64::planet_shade({1.0, -2.0, 0.0}, sun), 0.5, 1e-12);
}

}  // namespace
}  // namespace terrella
