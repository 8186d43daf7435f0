#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"
#include "laws/rounding.hpp"

namespace terrella {
namespace {

using test::Places;
using test::roundoff;

TEST(GridOffset, IsTheCotangentOfTheAngleToReach) {
  Places places(221U);
  for (int i = 0; i < 20'000; ++i) {
    const double r = std::pow(10.0, places.between(0.0, 8.0)), alt = r * std::pow(10.0, places.between(-8.0, 3.0));
    const double h_max = i % 4 == 0 ? 0.0 : r * std::pow(10.0, places.between(-8.0, 0.3));
    const f64::GridOffset g = f64::grid_offset(r, alt, h_max);
    ASSERT_NEAR(g.h, f64::horizon_distance(r, alt), 1e-15 * g.h);
    ASSERT_NEAR(g.s, f64::horizon_distance(r, h_max), 1e-15 * g.s);
    ASSERT_NEAR(g.phi, std::atan2(g.h, r) + std::atan2(g.s, r), 1e-12 * g.phi);
    ASSERT_NEAR(g.zs, std::cos(g.phi) / std::sin(g.phi), 1e-11 * (1.0 + std::fabs(g.zs)));
  }
}

TEST(GridOffset, OfAnEyeBelowTheSphereIsThatOfOneOnIt) {
  const f64::GridOffset below = f64::grid_offset(100.0, -30.0, 1.0), on = f64::grid_offset(100.0, 0.0, 1.0);
  EXPECT_EQ(below.zs, on.zs);
  EXPECT_EQ(below.phi, on.phi);
  EXPECT_EQ(below.h, 0.0);
}

TEST(GridOffset, ReachesTheHorizonWithinACentimetreInSinglePrecision) {
  // The print's form is off by 299 m of arc here.
  const double phi = f64::grid_offset(6.36e6, double{1.7F}, 8848.0).phi;
  const f32::GridOffset g = f32::grid_offset(6.36e6F, 1.7F, 8848.0F);
  EXPECT_NEAR(g.phi * 6.36e6, phi * 6.36e6, 0.03);
  EXPECT_NEAR(std::atan2(1.0, double{g.zs}) * 6.36e6, phi * 6.36e6, 0.03);
}

TEST(GridRise, IsOneInTheMiddleAndNothingAlongTheBorder) {
  for (const int n : {2, 4, 6, 10, 100}) {
    EXPECT_EQ(f64::grid_rise(0.0, 0.0, n), 1.0);
    for (const double g : {-1.0, -0.3, 0.0, 0.7, 1.0}) {
      EXPECT_EQ(f64::grid_rise(g, 1.0, n), 0.0);
      EXPECT_EQ(f64::grid_rise(-1.0, g, n), 0.0);
      const double x = 0.4;
      EXPECT_NEAR(f64::grid_rise(g, x, n), (1.0 - std::pow(std::fabs(g), n)) * (1.0 - std::pow(x, n)), 1e-15);
    }
  }
}

TEST(GridRise, KeepsItsDigitsNextToTheBorder) {
  for (const int n : {2, 4, 8, 22}) {
    const double next = 0x1p-20;
    const double expected = -std::expm1(n * std::log1p(-next));
    EXPECT_NEAR(f64::one_less_power(1.0 - next, n), expected, 1e-14 * expected);
    EXPECT_NEAR(f32::one_less_power(1.0F - 0x1p-20F, n), expected, (n + 6) * roundoff * expected);
  }
}

TEST(GridDirection, IsAUnitVectorAndTheEdgeReachesTheAngle) {
  const f64::GridOffset g = f64::grid_offset(1000.0, 3.0, 20.0);
  for (const double other : {0.0, 0.2}) {
    const glm::dvec3 edge = f64::grid_direction(1.0, other, f64::grid_rise(1.0, other, 4), g.zs);
    EXPECT_NEAR(glm::length(edge), 1.0, 1e-15);
    EXPECT_GT(edge.x, 0.0);
    EXPECT_NEAR(edge.y / edge.x, other, 1e-15);
    if (other == 0.0) {
      EXPECT_NEAR(std::atan2(edge.x, edge.z), g.phi, 1e-14);
    }
  }
  EXPECT_EQ(f64::grid_direction(0.0, 0.0, 1.0, g.zs), glm::dvec3(0.0, 0.0, 1.0));
}

TEST(CameraAxes, AreRightHandedWithTheEyeUp) {
  Places places(222U);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 w = places.on_sphere(), b = 7.0 * places.on_sphere();
    glm::dvec3 east, north;
    f64::camera_axes(w, b, east, north);
    ASSERT_LT(glm::distance(glm::cross(east, north), w), 1e-12);
    ASSERT_NEAR(glm::dot(north, b), 0.0, 1e-12);
    ASSERT_GT(glm::dot(north, glm::cross(w, b)), 0.0);
    ASSERT_NEAR(glm::length(east), 1.0, 1e-12);
  }
}

TEST(GridFromEye, IsTheVertexLessTheEye) {
  Places places(223U);
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 d = places.on_sphere();
    const double r = places.between(1.0, 100.0), alt = places.between(-0.5, 300.0);
    const glm::dvec3 expected = r * d - glm::dvec3(0.0, 0.0, r + alt);
    ASSERT_LT(glm::distance(f64::grid_from_eye(d, r, alt), expected), 1e-12 * (r + std::fabs(alt)));
  }
}

TEST(GridFromEye, HoldsAHundredthOfAPixelTwoMetresAwayOnAnyPlanet) {
  for (const double r : {1.0e8, 6.36e6, 1.0}) {
    const double alt = 1.7 * r / 6.36e6, away = 2.0 * r / 6.36e6;
    const auto across = static_cast<float>(away / r);
    const glm::vec3 d(across, 0.0F, 1.0F);
    const glm::vec3 rel = f32::grid_from_eye(d, static_cast<float>(r), static_cast<float>(alt));
    const double x = r * double{across},
                 down = -r * double{across} * double{across} / 2.0 - double{static_cast<float>(alt)};
    const double distance = std::hypot(x, down);
    EXPECT_NEAR(rel.x, x, 2.0 * roundoff * distance);
    EXPECT_NEAR(rel.z, down, 2.0 * roundoff * distance);  // 935 pixels a radian: 1.1e-4 pixels
  }
}

}  // namespace
}  // namespace terrella
