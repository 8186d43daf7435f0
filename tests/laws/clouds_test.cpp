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

TEST(CloudThickness, RisesFromItsThresholdOverItsSoftness) {
  // Half of the sky is covered where noise is positive, when edges are hard.
  EXPECT_EQ(f64::cloud_thickness(0.0, 0.5, 0.0), 0.0);
  EXPECT_NEAR(f64::cloud_thickness(0.015, 0.5, 0.0), 0.5, 1e-12);
  EXPECT_EQ(f64::cloud_thickness(0.03, 0.5, 0.0), 1.0);
  EXPECT_GT(f64::cloud_thickness(-0.4, 1.0, 0.0), 0.99);
  EXPECT_EQ(f64::cloud_thickness(0.4, 0.05, 0.0), 0.0);
  // Softer ones begin earlier and end later.
  EXPECT_GT(f64::cloud_thickness(-0.05, 0.5, 1.0), 0.0);
  EXPECT_LT(f64::cloud_thickness(0.4, 0.5, 1.0), 1.0);
}

TEST(Cyclones, TurnFurtherTheMoreTheyAreToldTo) {
  EXPECT_EQ(f64::cyclone_turn(0.0), 0.0);
  EXPECT_NEAR(2.0 * std::atan(f64::cyclone_turn(1.0)), 2.498, 1e-3);  // 143 degrees at the most
  EXPECT_NEAR(f64::cyclone_turn(0.5), 1.5, 1e-12);
}

TEST(Drifted, FollowsCloudsThatMoveEastwards) {
  const auto at = [](double longitude) {
    return glm::dvec3(0.8 * std::cos(longitude), 0.8 * std::sin(longitude), 0.6);
  };
  for (const double turn : {0.0, 0.4, 2.5, -1.0}) {
    for (const double longitude : {0.0, 1.0, -2.0}) {
      // What was at a longitude before is now further on by the turn.
      EXPECT_LT(glm::distance(f64::drifted(at(longitude + turn), turn_by(turn)), at(longitude)), 1e-12);
    }
  }
}

TEST(CloudNoiseOf, IsTheMeanOfLayersAndRisesAlongBelts) {
  EXPECT_DOUBLE_EQ(f64::cloud_noise_of(0.6, 1.5, 0.0, 0.3), 0.4);
  EXPECT_NEAR(f64::cloud_noise_of(0.6, 1.5, 1.0, 0.0) - 0.4, 0.22, 1e-12);   // the equator
  EXPECT_NEAR(f64::cloud_noise_of(0.6, 1.5, 0.5, 0.5) - 0.4, -0.11, 1e-12);  // 30 degrees
  EXPECT_NEAR(f64::cloud_noise_of(0.0, 1.5, 1.0, std::sin(std::numbers::pi / 12.0)), 0.0, 1e-12);
}

TEST(NoiseToMap, HoldsAllNoiseAndGivesItBack) {
  EXPECT_NEAR(f64::noise_to_map(-1.02), 0.0, 1e-15);
  EXPECT_NEAR(f64::noise_to_map(1.02), 1.0, 1e-15);
  EXPECT_EQ(f64::noise_to_map(0.0), 0.5);
  for (double noise = -1.02; noise <= 1.02; noise += 0.01) {
    EXPECT_NEAR(f64::noise_from_map(f64::noise_to_map(noise)), noise, 1e-15);
  }
}

// What moves an idea of one place by a seed moves all: clouds, ripples and the ground have nothing in common.
TEST(Seeds, OfCloudsAndRipplesDifferForEveryPlanet) {
  for (int seed = 0; seed < 100; ++seed) {
    EXPECT_NE(f64::cloud_seed(seed), f64::ripple_seed(seed));
    EXPECT_NE(f64::cloud_seed(seed), static_cast<unsigned>(seed));
    EXPECT_EQ(f64::cloud_seed(seed + 1), f64::cloud_seed(seed) + 1U);
    EXPECT_EQ(f64::ripple_seed(seed + 1), f64::ripple_seed(seed) + 1U);
  }
}

}  // namespace
}  // namespace terrella
