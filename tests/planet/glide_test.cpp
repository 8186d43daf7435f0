#include "planet/glide.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "laws/random_places.hpp"

namespace terrella {
namespace {

constexpr double rho = Glide::curvature;

// As van Wijk and Nuij print it: with a difference of hyperbolic sines that loses its digits where there is little
// distance, so that it is asked for none of these.
Glide::Point as_printed(double distance, double w0, double w1, double part) {
  const double rho2 = rho * rho, between = w1 * w1 - w0 * w0, square = rho2 * rho2 * distance * distance;
  const double r0 = -std::asinh((between + square) / (2.0 * w0 * rho2 * distance));
  const double r1 = -std::asinh((between - square) / (2.0 * w1 * rho2 * distance));
  const double at = r0 + part * (r1 - r0);
  return {w0 / rho2 * (std::cosh(r0) * std::tanh(at) - std::sinh(r0)), w0 * std::cosh(r0) / std::cosh(at)};
}

TEST(Glide, IsTheWayOfThePaper) {
  test::Places places(1U);
  for (int i = 0; i < 500; ++i) {
    const double distance = places.between(0.1, 10.0), w0 = places.between(0.1, 10.0), w1 = places.between(0.1, 10.0);
    const Glide glide(distance, w0, w1);
    const double part = places.between(0.0, 1.0);
    const Glide::Point told = glide.from_start(part), expected = as_printed(distance, w0, w1, part);
    EXPECT_NEAR(told.along, expected.along, 1e-10);
    EXPECT_NEAR(told.height, expected.height, 1e-10);
  }
}

TEST(Glide, LeadsFromEndToEnd) {
  test::Places places(2U);
  for (int i = 0; i < 2000; ++i) {
    const double distance = i % 7 == 0 ? 0.0 : std::pow(10.0, places.between(-12.0, 8.0));
    const double w0 = std::pow(10.0, places.between(-8.0, 16.0));
    const double w1 = i % 5 == 0 ? w0 : std::pow(10.0, places.between(-8.0, 16.0));
    const Glide glide(distance, w0, w1);
    ASSERT_TRUE(std::isfinite(glide.length()));
    EXPECT_EQ(glide.from_start(0.0).along, 0.0);
    EXPECT_EQ(glide.from_end(1.0).along, 0.0);
    EXPECT_NEAR(glide.from_start(0.0).height / w0, 1.0, 1e-14);
    EXPECT_NEAR(glide.from_end(1.0).height / w1, 1.0, 1e-14);
    EXPECT_NEAR(glide.from_start(1.0).height / w1, 1.0, 1e-11) << distance << ' ' << w0 << ' ' << w1;
    // Told by either end it is one way; what of the distance is small beside the height, nobody sees.
    for (const double part : {-0.3, 0.1, 0.5, 0.77, 1.2}) {
      const Glide::Point a = glide.from_start(part), b = glide.from_end(part);
      EXPECT_NEAR(a.height / b.height, 1.0, 1e-11);
      EXPECT_NEAR(a.along, b.along + distance, 1e-11 * (distance + a.height));
    }
  }
}

// What is perceived of each step is the same: the metric of the paper.
TEST(Glide, IsPerceivedAsEquallyFast) {
  test::Places places(3U);
  for (int i = 0; i < 200; ++i) {
    const double distance = std::pow(10.0, places.between(-3.0, 1.0));
    const Glide glide(distance, std::pow(10.0, places.between(-4.0, 3.0)), std::pow(10.0, places.between(-4.0, 3.0)));
    const double part = places.between(0.0, 1.0), step = 1e-5;
    const Glide::Point a = glide.from_start(part - step), b = glide.from_start(part + step);
    const double middle = glide.from_start(part).height;
    const double perceived = std::hypot(rho * (b.along - a.along), (b.height - a.height) / rho) / middle;
    EXPECT_NEAR(perceived / (2.0 * step), glide.length(), 1e-4 * glide.length());
  }
}

TEST(Glide, StraightDownFallsByTheSameFactor) {
  const Glide glide(0.0, 1e7, 2.0);
  EXPECT_NEAR(glide.length(), std::log(5e6) / rho, 1e-12);
  for (int i = 1; i <= 100; ++i) {
    const double factor = glide.from_start(0.01 * i).height / glide.from_start(0.01 * (i - 1)).height;
    EXPECT_NEAR(factor, std::pow(2e-7, 0.01), 1e-12);
    EXPECT_EQ(glide.from_start(0.01 * i).along, 0.0);
  }
}

TEST(Glide, RisesOnlyWhereItIsFar) {
  const auto highest = [](double distance) {
    const Glide glide(distance, 1.0, 1.0);
    double height = 0.0;
    for (int i = 0; i <= 100; ++i) height = std::max(height, glide.from_start(0.01 * i).height);
    return height;
  };
  EXPECT_LT(highest(0.1), 1.01);
  // Far away it is the circle's radius, half of the distance as the half-plane has it.
  EXPECT_NEAR(highest(1000.0), 500.0 * rho * rho, 1.0);
}

}  // namespace
}  // namespace terrella
