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
    glm::dvec3 warp(0.0), same(0.0);
    const double first = f64::flow_layer(d, 2.0, 0.7, 0.5, turn_by(0.3), 0, 1U, warp);
    EXPECT_LE(std::fabs(first), 0.7 * 1.02);
    EXPECT_EQ(first,
              f64::flow_layer(d, 2.0, 0.7, 0.0, turn_by(0.3), 0, 1U, same));  // nothing before it to be stirred by
    EXPECT_EQ(warp, same);
    // Without strength a later layer is the plain turned noise.
    const double plain = f64::flow_layer(d, 4.0, 0.35, 0.0, turn_by(0.6), 1, 1U, warp);
    glm::dvec3 fresh(0.0);
    EXPECT_EQ(plain, f64::flow_layer(d, 4.0, 0.35, 0.0, turn_by(0.6), 1, 1U, fresh));
  }
}

}  // namespace
}  // namespace terrella
