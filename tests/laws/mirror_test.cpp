// Land in the mirror of the water.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

TEST(AltitudeSeen, IsThatOfThePlace) {
  test::Places places(57U);
  for (int i = 0; i < 10'000; ++i) {
    const double r = places.between(0.5, 2.0), alt = std::pow(10.0, places.between(-6.0, 0.0));
    const glm::dvec3 eye = (r + alt) * places.on_sphere();
    const glm::dvec3 offset = std::pow(10.0, places.between(-6.0, 0.0)) * places.on_sphere();
    const double climb = glm::dot(offset, glm::normalize(eye));
    const double altitude = f64::altitude_seen(r, alt, climb, glm::dot(offset, offset));
    ASSERT_NEAR(altitude, glm::length(eye + offset) - r, 1e-14);
  }
}

// Of a place that the mirrored eye sees: from how steep it is, and its height, up to a part of the way over the radius.
TEST(WayInMirror, IsTheDistanceOfThePlace) {
  test::Places places(58U);
  for (int i = 0; i < 10'000; ++i) {
    const double r = 1.0, alt = std::pow(10.0, places.between(-7.0, -4.0));
    const double way = std::min(alt * std::pow(10.0, places.between(0.1, 3.0)), 0.02),
                 climb = places.between(0.01, 0.9);
    const glm::dvec3 mirrored(0.0, 0.0, r - alt), ray(std::sqrt(1.0 - climb * climb), 0.0, climb);
    const double height = glm::length(mirrored + way * ray) - r;
    const double found = f64::way_in_mirror(r, alt, climb, height / way);
    ASSERT_NEAR(found / way, 1.0, 0.015) << alt << ' ' << way << ' ' << climb;
  }
}

TEST(ThrownRays, AreQuartersOfANormalDistribution) {
  double mean = 0.0, square = 0.0;
  for (int i = 0; i < 4; ++i) {
    mean += 0.25 * f64::deviation_of_quarter(i);
    square += 0.25 * f64::deviation_of_quarter(i) * f64::deviation_of_quarter(i);
    EXPECT_NEAR(0.5 * std::erfc(-f64::deviation_of_quarter(i) / std::sqrt(2.0)), 0.125 + 0.25 * i, 0.001);
  }
  EXPECT_EQ(mean, 0.0);
  EXPECT_GT(square, 0.7);  // what is left lies within the quarters
}

// Slopes of waves whose lobe has a fourth power of roughness vary by half of that along each direction; those that face
// an eye near the water, a Rayleigh distribution, by (4 - pi) / 2 of it; a mirror turns rays by twice as much.
TEST(ThrownRays, SpreadAsSlopesThatFaceTheEye) {
  const double rough = 0.02, slope_variance = 0.5 * rough;
  const double seen = std::sqrt((4.0 - std::numbers::pi) / 2.0 * slope_variance);
  EXPECT_NEAR(f64::thrown_spread(rough), 2.0 * seen, 0.01 * seen);
}

TEST(ThrownRays, AreBlurredNoFinerThanTexels) {
  EXPECT_EQ(f64::level_of_spread(0.0, 1e-3), 0.0);
  EXPECT_EQ(f64::level_of_spread(1e-3, 1e-3), 0.0);
  EXPECT_NEAR(f64::level_of_spread(0.08, 1e-3), 6.0, 1e-12);
}

}  // namespace
}  // namespace terrella
