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
