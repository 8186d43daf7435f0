#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "formulas/formulas.hpp"

namespace terrella {
namespace {

TEST(ToneMap, RisesFromZeroAndNeverPassesOne) {
  for (int curve = 0; curve < 3; ++curve) {
    EXPECT_EQ(f64::tone_map(glm::dvec3(0.0), curve), glm::dvec3(0.0));
    double before = -1.0;
    for (double x = 1e-6; x < 1e6; x *= 1.3) {
      const double y = f64::tone_map(glm::dvec3(x), curve).x;
      EXPECT_GE(y, before);
      EXPECT_LE(y, 1.0);
      before = y;
    }
  }
}

TEST(ToneMap, StandsTheBrightestLightThatHalfFloatsHold) {
  EXPECT_TRUE(std::isfinite(f32::tone_map(glm::vec3(65504.0F), 0).x));
  EXPECT_TRUE(std::isfinite(f32::tone_map(glm::vec3(1e30F), 0).x));
}

TEST(Srgb, IsTheStandardsCurve) {
  EXPECT_NEAR(f64::srgb_encode(0.0), 0.0, 1e-12);
  EXPECT_NEAR(f64::srgb_encode(1.0), 1.0, 1e-12);
  const auto exact = [](double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055; };
  double before = -1.0;
  for (int i = 0; i <= 100'000; ++i) {
    const double x = i / 100'000.0;
    const double y = f64::srgb_encode(x);
    ASSERT_NEAR(y, exact(x), 4e-5) << x;  // measured: 3.8e-5
    ASSERT_GT(y, before) << x;
    before = y;
  }
}

TEST(Dither, IsBalancedAndWithinOneStep) {
  double sum = 0.0;
  std::vector<int> histogram(20);
  const int side = 400;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double d = f64::dither(glm::dvec2(x, y));
      ASSERT_GE(d, -1.0);
      ASSERT_LE(d, 1.0);
      sum += d;
      ++histogram[static_cast<std::size_t>(std::fmin(19.0, (d + 1.0) * 10.0))];
    }
  }
  EXPECT_NEAR(sum / (side * side), 0.0, 0.01);
  // A triangle: most in the middle, few at the ends.
  EXPECT_GT(histogram[9] + histogram[10], 6 * (histogram[0] + histogram[19]));
}

TEST(Luminance, OfWhiteIsOneAndMostOfItGreen) {
  EXPECT_NEAR(f64::luminance(glm::dvec3(1.0)), 1.0, 1e-12);
  EXPECT_NEAR(f64::luminance({1.0, 0.0, 0.0}), 0.2126, 1e-12);  // IEC 61966-2-1
  EXPECT_NEAR(f64::luminance({0.0, 0.0, 1.0}), 0.0722, 1e-12);
}

TEST(ToneMap, CurvesPassTheirKnownPoints) {
  // Narkowicz's curve at 1 is 2.54 / 3.16; the exposure before it is 0.6.
  EXPECT_NEAR(f64::filmic(1.0 / 0.6), 2.54 / 3.16, 1e-12);
  EXPECT_LT(f64::filmic(0.01) / 0.01, f64::filmic(0.05) / 0.05);  // a toe
  // Reinhard: luminance L becomes L / (1 + L), and colours keep their proportions.
  const glm::dvec3 light(0.5, 3.0, 0.2), mapped = f64::tone_map(light, 1);
  const double l = f64::luminance(light);
  EXPECT_NEAR(f64::luminance(mapped), l / (1.0 + l), 1e-12);
  EXPECT_NEAR(mapped.g / mapped.r, 6.0, 1e-12);
  EXPECT_EQ(f64::tone_map({0.5, 3.0, 0.2}, 2), glm::dvec3(0.5, 1.0, 0.2));
}

TEST(Srgb, TakesEachChannelAndHoldsItToItsEnds) {
  const glm::dvec3 encoded = f64::srgb({0.5, 2.0, -1.0});
  EXPECT_EQ(encoded.r, f64::srgb_encode(0.5));
  EXPECT_EQ(encoded.g, f64::srgb_encode(1.0));
  EXPECT_EQ(encoded.b, f64::srgb_encode(0.0));
}

}  // namespace
}  // namespace terrella
