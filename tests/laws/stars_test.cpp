#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/equal.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::expect_equal;
using test::Places;

const glm::dvec3 tint(0.9, 0.6, 0.3);

TEST(SoftDisc, IsBrightestInTheMiddleAndNoneFromTwoRadiiOn) {
  EXPECT_NEAR(f64::soft_disc(0.0), 1.0, 1e-3);
  EXPECT_EQ(f64::soft_disc(4.0), 0.0);
  EXPECT_EQ(f64::soft_disc(9.0), 0.0);
  EXPECT_NEAR(f64::soft_disc(1.0), std::exp(-1.8), 1e-3);
  for (double away2 = 0.0; away2 < 4.0; away2 += 0.01) EXPECT_GT(f64::soft_disc(away2), f64::soft_disc(away2 + 0.01));
}

TEST(StarRadius, IsTwiceAsLargeForTheBrightestAsForTheFaintest) {
  EXPECT_DOUBLE_EQ(f64::star_radius(1.0, 0.0), 0.8);
  EXPECT_DOUBLE_EQ(f64::star_radius(1.0, 1.0), 1.6);
  EXPECT_DOUBLE_EQ(f64::star_radius(3.0, 0.5), 3.6);
}

TEST(StarLight, OfTheFaintestIsATenthOfAll) {
  expect_equal(f64::star_light(tint, 0.0, 5.0), 0.5 * tint);
  expect_equal(f64::star_light(tint, 1.0, 1.0), 2.3 * tint);
  expect_equal(f64::star_light(tint, 0.5, 3.0), 3.0 * 1.2 * tint);
  expect_equal(f64::star_light(tint, 1.0, 0.0), glm::dvec3(0.0));
}

TEST(StarColor, RunsFromRedThroughWhiteToBlueOfAboutTheSameLuminance) {
  EXPECT_GT(f64::star_color(-1.0).r, 2.0 * f64::star_color(-1.0).b);
  EXPECT_GT(f64::star_color(1.0).b, 1.5 * f64::star_color(1.0).r);
  const double white = f64::luminance(f64::star_color(0.0));
  for (double warmth = -1.0; warmth < 1.0; warmth += 0.01) {
    const glm::dvec3 color = f64::star_color(warmth), next = f64::star_color(warmth + 0.01);
    EXPECT_GT(next.b / next.r, color.b / color.r);
    EXPECT_LT(glm::distance(color, next), 0.01);
    EXPECT_NEAR(f64::luminance(color) / white, 1.0, 0.21);  // measured: 0.79 where it is bluest
  }
}

// What is drawn out along the plane changes 2.2 times as fast across it.
TEST(BandNoise, IsDrawnOutAlongTheBand) {
  Places places(341U);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.2, -0.5, 0.8));
  const glm::dvec3 along = f64::perpendicular(normal);
  double across2 = 0.0, along2 = 0.0;
  const double h = 1e-5;
  for (int i = 0; i < 40'000; ++i) {
    const glm::dvec3 d = places.on_sphere();
    const auto change = [&](const glm::dvec3& step) {
      return (f64::band_noise(d + h * step, normal, 7.0, 3U) - f64::band_noise(d - h * step, normal, 7.0, 3U)) /
             (2.0 * h);
    };
    across2 += change(normal) * change(normal);
    along2 += change(along) * change(along);
    ASSERT_LE(std::fabs(f64::band_noise(d, normal, 7.0, 3U)), 1.02);
  }
  EXPECT_NEAR(std::sqrt(across2 / along2), 2.2, 0.05);
}

double mean_brightness(double across, const glm::dvec3& normal) {
  const glm::dvec3 east = f64::perpendicular(normal), north = glm::cross(normal, east);
  const double level = std::sqrt(1.0 - across * across);
  double sum = 0.0;
  const int count = 2000;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    sum += f64::band_brightness(across * normal + level * (std::cos(angle) * east + std::sin(angle) * north), normal,
                                static_cast<unsigned>(i % 20));
  }
  return sum / count;
}

TEST(BandBrightness, FillsABandWithDustAlongItsMiddle) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.2, -0.5, 0.8));
  Places places(342U);
  double most = 0.0;
  for (int i = 0; i < 50'000; ++i) {
    const glm::dvec3 d = places.on_sphere();
    const double brightness = f64::band_brightness(d, normal, 5U);
    ASSERT_GE(brightness, 0.0);
    ASSERT_LE(brightness, 1.0);
    most = std::fmax(most, brightness);
    // Clouds and veils widen it by a quarter at the most.
    if (std::fabs(glm::dot(d, normal)) > 1.3 * f64::band_half_width) {
      ASSERT_EQ(brightness, 0.0);
    }
  }
  EXPECT_GT(most, 0.85);
  const double middle = mean_brightness(0.0, normal), beside = mean_brightness(0.07, normal);
  // Without dust three quarters would be left in the middle; further out, where the band is down to 0.6, as much as
  // there.
  EXPECT_NEAR(middle, 0.44, 0.04);  // measured 0.4445
  EXPECT_NEAR(beside, 0.43, 0.04);  // measured 0.4275
  EXPECT_LT(mean_brightness(0.14, normal), 0.5 * beside);
  EXPECT_NEAR(mean_brightness(-0.07, normal) / beside, 1.0, 0.15);
}

TEST(BandLight, IsInProportionToAllAndWarmWhereItIsFaint) {
  expect_equal(f64::band_light(0.0, 3.0), glm::dvec3(0.0));
  expect_equal(f64::band_light(0.7, 3.0), 3.0 * f64::band_light(0.7, 1.0));
  expect_equal(f64::band_light(1.0, 1.0), 0.085 * glm::dvec3(0.72, 0.84, 1.1));
  glm::dvec3 before = f64::band_light(1e-6, 1.0);
  EXPECT_GT(before.r, before.b);
  for (double brightness = 0.01; brightness <= 1.0; brightness += 0.01) {
    const glm::dvec3 light = f64::band_light(brightness, 1.0);
    EXPECT_GT(light.g, before.g);
    EXPECT_GT(light.b / light.r, before.b / before.r);
    before = light;
  }
}

f64::SceneLight with_sun(const glm::dvec3& sun) {
  f64::SceneLight scene;
  scene.eye = glm::dvec3(0.0);
  scene.eye_height = 0.0;
  scene.sun = sun;
  scene.sunlight = glm::dvec3(1.0);
  scene.ambient = 0.0;
  scene.sky_glow = glm::dvec3(0.0);
  scene.air = {1.1, 0.5, 3.0, 0.2, glm::dvec3(1.0), glm::dvec3(1.0)};
  return scene;
}

const glm::dvec3 town_place(0.0, 0.0, 1.0);
constexpr double pixel = 1e-3;

f64::TownLight town(const glm::dvec3& offset, double brightness = 1.0, double all = 1.0) {
  return f64::town_light(town_place, offset, brightness, tint, all, pixel, with_sun(-town_place));
}

TEST(TownLight, FromNearIsAsWideAsATownAndOfTheSameLight) {
  for (const double away : {0.1, 0.5, 1.0}) {
    const f64::TownLight seen = town({0.0, 0.0, -away});
    EXPECT_NEAR(seen.radius * pixel * away, 0.0015, 1e-12);
    expect_equal(seen.light, 4.0 * tint);
  }
}

TEST(TownLight, FromAfarStaysAPixelAndDimsWithTheSquareOfTheDistance) {
  const double even = 0.0015 / (0.9 * pixel);  // from where on it is no wider
  EXPECT_NEAR(town({0.0, 0.0, -0.999 * even}).light.r, 4.0 * tint.r, 1e-12);
  for (const double farther : {2.0, 10.0}) {
    const f64::TownLight seen = town({0.0, 0.0, -farther * even});
    EXPECT_EQ(seen.radius, 0.9);
    expect_equal(seen.light, 4.0 / (farther * farther) * tint);
  }
}

TEST(TownLight, IsInProportionToItsBrightnessAndOnlyOnTheNightSide) {
  expect_equal(town({0.0, 0.0, -1.0}, 0.3, 2.0).light, 0.6 * town({0.0, 0.0, -1.0}).light);
  for (const double climb : {-0.5, -0.03, 0.0, 0.2}) {
    const f64::SceneLight scene = with_sun({std::sqrt(1.0 - climb * climb), 0.0, climb});
    expect_equal(f64::town_light(2.0 * town_place, {0.0, 0.0, -1.0}, 1.0, tint, 1.0, pixel, scene).light,
                 4.0 * f64::night_share(climb) * tint);
  }
}

TEST(TownLight, FadesTowardsTheLimbAndIsHiddenBehindIt) {
  const auto from = [](double cosine) {
    return town({std::sqrt(1.0 - cosine * cosine), 0.0, -cosine}).light.r / (4.0 * tint.r);
  };
  EXPECT_NEAR(from(0.2), 0.5, 1e-12);
  EXPECT_NEAR(from(0.4), 1.0, 1e-12);
  EXPECT_EQ(from(0.0), 0.0);
  EXPECT_EQ(from(-0.5), 0.0);
}

}  // namespace
}  // namespace terrella
