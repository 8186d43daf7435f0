#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

glm::dvec2 turn_by(double angle) { return {std::cos(angle), std::sin(angle)}; }

TEST(CloudThickness, GrowsWithNoiseAndCoverage) {
  for (double coverage = 0.0; coverage <= 1.0; coverage += 0.1) {
    double before = 0.0;
    for (double noise = -1.0; noise <= 1.0; noise += 0.01) {
      const double thickness = f64::cloud_thickness(noise, coverage, 0.5);
      EXPECT_GE(thickness, before);
      EXPECT_LE(thickness, 1.0);
      EXPECT_LE(thickness, f64::cloud_thickness(noise, std::fmin(1.0, coverage + 0.1), 0.5) + 1e-12);
      before = thickness;
    }
  }
}

TEST(CloudThickness, IsNothingWithoutCoverage) {
  for (double noise = -1.0; noise <= 1.0; noise += 0.1) EXPECT_EQ(f64::cloud_thickness(noise, 0.0, 1.0), 0.0);
}

TEST(Cyclones, LieAtMidLatitudesNorthAndSouthByTurns) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    for (int i = 0; i < f64::cyclone_count; ++i) {
      const glm::dvec4 place = f64::cyclone_place(i, seed);
      EXPECT_NEAR(glm::length(glm::dvec3(place)), 1.0, 1e-12);
      EXPECT_GE(i % 2 == 0 ? place.z : -place.z, 0.26);
      EXPECT_LE(std::fabs(place.z), 0.77);
    }
  }
}

TEST(Unwound, TurnsTheEyeByTheAngleAndLeavesTheRestAlone) {
  const glm::dvec4 north(0.0, 0.8, 0.6, 0.5);
  const glm::dvec3 eye(north);
  const double angle = 1.1;
  // So near the eye that all of the angle is left.
  const glm::dvec3 side = glm::normalize(glm::cross(eye, glm::dvec3(1.0, 0.0, 0.0)));
  const glm::dvec3 moved = f64::unwound(glm::normalize(eye + 1e-5 * side), north, std::tan(0.5 * angle)) - eye;
  const glm::dvec3 expected = std::cos(angle) * side - std::sin(angle) * glm::cross(eye, side);
  EXPECT_LT(glm::distance(moved / 1e-5, expected), 1e-4);

  test::Places places(62U);
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 d = places.on_sphere();
    const glm::dvec3 there = f64::unwound(d, north, 3.0);
    ASSERT_NEAR(glm::length(there), 1.0, 1e-12);
    ASSERT_NEAR(glm::distance(there, eye), glm::distance(d, eye), 1e-12);
    if (glm::distance(d, eye) > 0.5) {
      ASSERT_EQ(there, d);
    }
    ASSERT_EQ(f64::unwound(d, north, 0.0), d);
  }
}

TEST(CloudBelt, IsTheCosineOfSixTimesTheLatitude) {
  for (double latitude = -1.57; latitude < 1.57; latitude += 0.01) {
    EXPECT_NEAR(f64::cloud_belt(std::sin(latitude)), std::cos(6.0 * latitude), 1e-12);
  }
}

TEST(FlowLayer, IsBoundedByItsAmplitudeAndWarpsOnlyLaterLayers) {
  test::Places places(61U);
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 d = places.on_sphere();
    glm::dvec3 warp(0.0);
    // Nothing before the first layer could stir it.
    EXPECT_EQ(f64::flow_place(d, 2.0, 0.5, warp, 0, 1U), f64::flow_place(d, 2.0, 0.0, warp, 0, 1U));
    EXPECT_LE(std::fabs(f64::flow_layer(f64::flow_place(d, 2.0, 0.5, warp, 0, 1U), 0.7, turn_by(0.3), 0, 1U, warp)),
              0.7 * 1.02);
    // The next is moved by what the first has left, times the strength.
    const glm::dvec3 moved = f64::flow_place(d, 4.0, 0.5, warp, 1, 1U) - f64::flow_place(d, 4.0, 0.0, warp, 1, 1U);
    EXPECT_LE(glm::length(moved - 0.5 * warp), 1e-12);
    EXPECT_GT(glm::length(warp), 0.0);
  }
}

}  // namespace
}  // namespace terrella
