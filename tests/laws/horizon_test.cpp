#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"
#include "laws/rounding.hpp"

namespace terrella {
namespace {

using test::Places;
using test::roundoff;
constexpr double earth = 6.36e6;

TEST(Horizon, LineOfSightAndRadiusMakeARightAngle) {
  Places places(211U);
  for (int i = 0; i < 20'000; ++i) {
    const double r = std::pow(10.0, places.between(0.0, 8.0)), alt = r * std::pow(10.0, places.between(-4.0, 3.0));
    const double distance = f64::horizon_distance(r, alt), angle = f64::cap_angle(r, alt);
    ASSERT_NEAR(std::hypot(distance, r) / (r + alt), 1.0, 1e-14);
    ASSERT_NEAR(std::cos(angle) * (r + alt) / r, 1.0, 1e-12);
    ASSERT_NEAR(std::tan(angle) * r / distance, 1.0, 1e-12);
  }
}

TEST(Horizon, HoldsATenthOfAMillimetreAboveTheEarth) {
  const double expected = std::sqrt(2.0 * 1e-4 / earth);  // to a part of alt / r
  EXPECT_NEAR(f64::cap_angle(earth, 1e-4), expected, 1e-9 * expected);
  EXPECT_NEAR(f32::cap_angle(6.36e6F, 1e-4F), expected, 8.0 * roundoff * expected);
  EXPECT_EQ(f32::cap_angle(6.36e6F, 0.0F), 0.0F);
}

TEST(Horizon, TerrainIsHiddenWhereItsOwnHorizonEnds) {
  // Someone on the highest terrain, just at that arc, looks along the same tangent line.
  for (const double alt : {0.0, 1.7, 1e4, 1e7}) {
    for (const double h_max : {0.0, 8848.0}) {
      const double arc = f64::hidden_angle(earth, alt, h_max);
      EXPECT_NEAR(arc, f64::hidden_angle(earth, h_max, alt), 1e-15);
      // The line between both touches the sphere: its distance from the centre is r.
      const double a = earth + alt, b = earth + h_max;
      const double chord = std::sqrt(a * a + b * b - 2.0 * a * b * std::cos(arc));
      if (chord > 1.0) {
        EXPECT_NEAR(a * b * std::sin(arc) / chord, earth, 1e-6 * earth);
      }
    }
  }
}

TEST(SplitDistance, EdgeCoversJustSoManyPixels) {
  Places places(212U);
  for (int i = 0; i < 20'000; ++i) {
    const double edge = std::pow(10.0, places.between(-3.0, 8.0)), most = places.between(0.5, 20.0);
    const double fov = places.between(0.017, 3.05), width = places.between(1.0, 8000.0);
    const double distance = f64::split_distance(edge, most, fov, width);
    ASSERT_NEAR(edge / (2.0 * distance * std::tan(0.5 * fov)) * width, most, 1e-11 * most);
  }
  // 60 degrees, 1000 pixels wide: 2 pixels are 0.0023 of the distance.
  EXPECT_NEAR(f64::split_distance(1.0, 2.0, std::numbers::pi / 3.0, 1000.0), 433.0127018922193, 1e-9);
}

}  // namespace
}  // namespace terrella
