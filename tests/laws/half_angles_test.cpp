#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"
#include "laws/rounding.hpp"

namespace terrella {
namespace {

using test::Places;
using test::roundoff;

TEST(HalfAngles, ArcTangentAndTangentAreTheLibrarysInSinglePrecision) {
  double worst_arc = 0.0, worst_tangent = 0.0;
  for (int i = 1; i <= 200'000; ++i) {
    const float t = static_cast<float>(i) / 200'000.0F, angle = t * 0.785398F;
    worst_arc = std::fmax(worst_arc, std::fabs(f32::arc_tangent(t) / std::atan(double{t}) - 1.0));
    worst_tangent = std::fmax(worst_tangent, std::fabs(f32::tangent(angle) / std::tan(double{angle}) - 1.0));
    ASSERT_EQ(f64::arc_tangent(double{t}), std::atan(double{t}));
    ASSERT_EQ(f64::tangent(double{angle}), std::tan(double{angle}));
  }
  EXPECT_LT(worst_arc, 2.0e-7);      // measured 1.4e-7
  EXPECT_LT(worst_tangent, 3.0e-7);  // measured 1.8e-7
  EXPECT_EQ(f32::arc_tangent(0.0F), 0.0F);
  EXPECT_EQ(f32::tangent(0.0F), 0.0F);
}

TEST(HalfAngles, AngleOfAPointIsInEveryQuadrantThatOfTheLibrary) {
  Places places(201U);
  for (int i = 0; i < 100'000; ++i) {
    const double size = std::pow(10.0, places.between(-6.0, 6.0));
    const float x = static_cast<float>(places.between(-size, size)), y = static_cast<float>(places.between(-1.0, 1.0));
    const double expected = std::atan2(double{y}, double{x});
    ASSERT_NEAR(f32::angle_of(y, x), expected, 8.0 * roundoff * std::fabs(expected)) << y << " " << x;
    ASSERT_NEAR(f64::angle_of(double{y}, double{x}), expected, 1e-14);
  }
  EXPECT_EQ(f64::angle_of(0.0, 0.0), 0.0);
  EXPECT_EQ(f64::angle_of(0.0, -2.0), std::numbers::pi);
  EXPECT_EQ(f64::angle_of(3.0, 0.0), 0.5 * std::numbers::pi);
  EXPECT_EQ(f64::angle_of(-3.0, 0.0), -0.5 * std::numbers::pi);
}

TEST(HalfAngles, AngleBetweenVectorsHoldsNearNothingAndNearAHalfTurn) {
  Places places(202U);
  for (int i = 0; i < 100'000; ++i) {
    const glm::dvec3 a = places.on_sphere(), side = f64::perpendicular(a);
    double angle = std::pow(10.0, places.between(-7.0, 0.49));
    if (i % 2 == 0) angle = std::numbers::pi - angle;
    const double size = std::pow(10.0, places.between(-6.0, 8.0));
    const glm::dvec3 b = std::cos(angle) * a + std::sin(angle) * side;
    ASSERT_NEAR(f64::angle_between(size * a, size * b), angle, 1e-14 * (1.0 + angle));
    const glm::vec3 c(size * a), d(size * b);  // their own angle is what single precision is held to
    const double own = f64::angle_between(glm::dvec3(c), glm::dvec3(d));
    const double lengths = std::fabs(glm::length(glm::dvec3(c)) / glm::length(glm::dvec3(d)) - 1.0);
    ASSERT_NEAR(f32::angle_between(c, d), own, 8.0 * roundoff * (own + lengths));
  }
  const glm::dvec3 v(0.3, -0.4, 0.5);
  EXPECT_EQ(f64::angle_between(v, v), 0.0);
  EXPECT_EQ(f64::angle_between(v, -v), std::numbers::pi);
  EXPECT_NEAR(f64::angle_between({2.0, 0.0, 0.0}, {0.0, 1.5, 0.0}), 0.5 * std::numbers::pi, 1e-15);
}

}  // namespace
}  // namespace terrella
