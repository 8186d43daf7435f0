#include <gtest/gtest.h>

#include "formulas/formulas.hpp"

namespace terrella {
namespace {

f64::Bands bands() {
  f64::Bands b;
  b.sand = {0.7, 0.55, 0.3};
  b.land = {0.1, 0.2, 0.05};
  b.mountain = {0.2, 0.18, 0.16};
  b.snow = {0.9, 0.95, 1.0};
  b.seabed = {0.4, 0.3, 0.15};
  b.sand_height = 0.004;
  b.mountain_height = 0.03;
  b.snow_height = 0.06;
  b.softness = 0.3;
  b.slope_rock = 0.5;
  b.thinning = 0.6;
  b.snow_sine = 0.93;
  return b;
}

glm::dvec3 on_plain(double height, const f64::Bands& b) { return f64::ground_color(height, 0.0, 0.0, 0.0, 0.0, b); }

TEST(GroundColor, IsThatOfEachBandInItsMiddle) {
  const f64::Bands b = bands();
  EXPECT_LT(glm::distance(on_plain(0.045, b), b.mountain), 1e-9);
  EXPECT_LT(glm::distance(on_plain(0.1, b), b.snow), 1e-9);
  EXPECT_LT(glm::distance(on_plain(0.0095, b), b.land), 0.05);
}

TEST(GroundColor, SandIsDarkerWhereItIsWet) {
  const f64::Bands b = bands();
  const double wet = on_plain(0.0, b).x / glm::mix(b.seabed, b.sand, 0.5).x, dry = on_plain(0.0022, b).x / b.sand.x;
  EXPECT_LT(wet, 0.8);
  EXPECT_GT(dry, 0.95);
}

TEST(GroundColor, VegetationThinsWithHeightOnlyAsFarAsAsked) {
  f64::Bands b = bands();
  const double low = on_plain(0.01, b).y / on_plain(0.01, b).x, high = on_plain(0.022, b).y / on_plain(0.022, b).x;
  EXPECT_LT(high, low);
  b.thinning = 0.0;
  EXPECT_LT(glm::distance(on_plain(0.02, b), b.land), 1e-9);
}

TEST(GroundColor, SnowLiesAtThePolesDownToTheWaterAndClingsLessToSlopes) {
  const f64::Bands b = bands();
  EXPECT_LT(glm::distance(f64::ground_color(0.01, 0.0, 0.0, 1.0, 0.0, b), b.snow), 1e-9);
  const double steep = f64::ground_color(0.1, 0.5, 0.0, 0.0, 0.0, b).z,
               flat = f64::ground_color(0.1, 0.0, 0.0, 0.0, 0.0, b).z;
  EXPECT_LT(steep, 0.7 * flat);
}

TEST(GroundColor, ChangesWithoutAStepOverTheShore) {
  const f64::Bands b = bands();
  glm::dvec3 before = on_plain(-0.01, b);
  for (double height = -0.01; height < 0.1; height += 1e-6) {
    const glm::dvec3 color = on_plain(height, b);
    ASSERT_LT(glm::distance(color, before), 1e-3) << height;
    before = color;
  }
}

TEST(GroundAlbedo, IsDarkerInHollowsAsFarAsAsked) {
  f64::Bands b = bands();
  b.sea = {0.01, 0.02, 0.05};
  const glm::dvec3 up(0.6, 0.0, 0.8);
  f64::GroundAt ground{glm::dvec3(0.0), 0.0, 0.01};
  b.hollows = 0.0;
  const glm::dvec3 plain = f64::ground_albedo(up, ground, up, b);
  EXPECT_LT(glm::distance(plain, f64::ground_color(0.01, 0.0, 0.0, 0.8, 0.0, b)), 1e-12);
  b.hollows = 1.0;
  EXPECT_LT(glm::distance(f64::ground_albedo(up, ground, up, b), 0.5 * plain), 1e-12);
  ground.openness = 1.0;
  EXPECT_LT(glm::distance(f64::ground_albedo(up, ground, up, b), 1.3 * plain), 1e-12);
  b.hollows = 0.5;
  EXPECT_LT(glm::distance(f64::ground_albedo(up, ground, up, b), 1.15 * plain), 1e-12);
}

TEST(GroundAlbedo, KnowsSlopesByTheNormalAndBreaksUpLinesByTheGradient) {
  f64::Bands b = bands();
  b.sea = {0.01, 0.02, 0.05};
  b.hollows = 0.0;
  const glm::dvec3 up(0.6, 0.0, 0.8), aside(0.8, 0.0, -0.6);
  f64::GroundAt ground{glm::dvec3(0.0), 0.5, 0.01};
  const glm::dvec3 steep = f64::ground_albedo(up, ground, 0.6 * up + 0.8 * aside, b);
  EXPECT_LT(glm::distance(steep, f64::ground_color(0.01, 0.4, 0.0, 0.8, 0.0, b)), 1e-12);
  ground.gradient = {0.61, -0.52, 0.60};  // 0.8 of its square, 1.0025
  EXPECT_LT(glm::distance(f64::ground_albedo(up, ground, up, b),
                          f64::ground_color(0.01, 0.0, 0.0, 0.8, 0.8 * glm::dot(ground.gradient, ground.gradient), b)),
            1e-12);
  ground.gradient *= -9.0;
  EXPECT_LT(glm::distance(f64::ground_albedo(up, ground, up, b), f64::ground_color(0.01, 0.0, 0.0, 0.8, -1.0, b)),
            1e-12);
}

TEST(Grained, ChangesNothingInTheMeanAndAThirdAtTheMost) {
  const glm::dvec3 albedo(0.4, 0.2, 0.1);
  EXPECT_EQ(f64::grained(albedo, 0.0), albedo);
  EXPECT_LT(glm::distance(f64::grained(albedo, 1.0), 1.35 * albedo), 1e-12);
  EXPECT_LT(glm::distance(f64::grained(albedo, 0.3) + f64::grained(albedo, -0.3), 2.0 * albedo), 1e-12);
}

TEST(GroundLight, FollowsLambertAndTheCloudsBeforeTheSun) {
  f64::SceneLight scene;
  scene.eye = {0.0, 0.0, 3.0};
  scene.eye_height = 2.0;
  scene.sun = {0.0, 0.0, 1.0};
  scene.sunlight = {2.0, 1.8, 1.5};
  scene.ambient = 0.1;
  scene.sky_glow = glm::dvec3(0.0);
  scene.air = {1.1, 0.5, 3.0, 0.2, {0.3, 0.5, 1.0}, {1.0, 0.4, 0.2}};
  const glm::dvec3 albedo(0.4, 0.2, 0.1), up(0.0, 0.6, 0.8);
  const f64::LightAt at = f64::light_at(up, 0.0, scene);
  const auto by_sun = [&](double cosine, double shade) {  // without what the sky gives
    const glm::dvec3 normal(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    const glm::dvec3 sky = albedo * f64::skylight(at, normal, scene) * (0.7 + 0.3 * shade) * 0.6;
    return f64::ground_light(albedo, normal, at, shade, scene) - sky;
  };
  EXPECT_LT(glm::distance(by_sun(1.0, 1.0), 0.6 * albedo * at.sun), 1e-12);
  EXPECT_LT(glm::distance(by_sun(0.5, 1.0), 0.3 * albedo * at.sun), 1e-12);
  EXPECT_LT(glm::distance(by_sun(0.5, 0.4), 0.12 * albedo * at.sun), 1e-12);
  EXPECT_LT(glm::length(by_sun(1.0, 0.0)), 1e-12);
  EXPECT_LT(glm::length(by_sun(-0.5, 1.0)), 1e-12);
  // No more than what falls in.
  EXPECT_LT(f64::ground_light(glm::dvec3(1.0), scene.sun, at, 1.0, scene).r,
            at.sun.r + f64::skylight(at, scene.sun, scene).r);
}

// Beside the mean over slopes that spread as a bell curve does, by sums.
TEST(MeanCosine, IsThatOfSlopesAroundAMean) {
  for (const double variance : {0.01, 0.05, 0.2, 0.5, 2.0}) {
    for (double angle = 0.0; angle < 2.2; angle += 0.1) {
      const glm::dvec3 sun(std::sin(angle), 0.0, std::cos(angle));
      double cosines = 0.0, weights = 0.0;
      glm::dvec3 normals(0.0);
      for (double x = -4.0; x <= 4.0; x += 0.05) {
        for (double y = -4.0; y <= 4.0; y += 0.05) {
          const double weight = std::exp(-0.5 * (x * x + y * y));
          const glm::dvec3 slope = std::sqrt(variance) * glm::dvec3(x, y, 0.0);
          const glm::dvec3 normal = glm::normalize(glm::dvec3(0.0, 0.0, 1.0) - slope);
          cosines += weight * std::max(glm::dot(normal, sun), 0.0);
          normals += weight * normal;
          weights += weight;
        }
      }
      const glm::dvec3 mean(0.0, 0.0, f64::mean_normal_length(variance));
      EXPECT_NEAR(glm::length(normals) / weights, mean.z, 0.02);
      EXPECT_NEAR(f64::mean_cosine(mean, sun), cosines / weights, 0.08 * std::sqrt(variance))
          << variance << ' ' << angle;
    }
  }
}

// Beside the mean over slopes that spread as a bell curve does, each as large as the eye sees it.
TEST(MeanSeenSlope, IsThatOfWhatFacesTheEye) {
  for (const double variance : {0.01, 0.1, 0.5, 2.0}) {
    for (double angle = 0.0; angle < 1.57; angle += 0.1) {
      const glm::dvec3 up(0.0, 0.0, 1.0), to_eye(std::sin(angle), 0.0, std::cos(angle));
      double slopes = 0.0, seen = 0.0;
      for (double x = -5.0; x <= 5.0; x += 0.01) {
        const double slope = std::sqrt(variance) * x;
        const double size = std::exp(-0.5 * x * x) * std::max(to_eye.z - slope * to_eye.x, 0.0);
        slopes += size * slope;
        seen += size;
      }
      const glm::dvec3 mean = f64::mean_seen_slope(variance, up, to_eye);
      EXPECT_NEAR(mean.x, slopes / seen, 0.09 * std::sqrt(variance)) << variance << ' ' << angle;
      EXPECT_EQ(mean.y, 0.0);
      EXPECT_EQ(mean.z, 0.0);
    }
  }
  EXPECT_EQ(f64::mean_seen_slope(0.0, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}), glm::dvec3(0.0));
}

// Steps of steepness beside their mean over slopes that spread as a bell curve does.
TEST(GroundColor, OfSlopesThatSpreadIsTheMeanOfTheirs) {
  f64::Bands b = bands();
  b.slope_rock = 1.0;
  const auto rock = [&](double steepness, double spread) {
    return f64::ground_color(0.1, steepness, spread, 0.0, 0.0, b).x;
  };
  for (const double variance : {0.03, 0.1, 0.3, 1.0}) {
    for (const double slope : {0.0, 0.3, 0.6, 1.0}) {
      double mean = 0.0, weights = 0.0;
      glm::dvec3 normals(0.0);
      for (double x = -4.0; x <= 4.0; x += 0.1) {
        for (double y = -4.0; y <= 4.0; y += 0.1) {
          const double weight = std::exp(-0.5 * (x * x + y * y));
          const glm::dvec3 slopes(slope + std::sqrt(variance) * x, std::sqrt(variance) * y, 0.0);
          const glm::dvec3 normal = glm::normalize(glm::dvec3(0.0, 0.0, 1.0) - slopes);
          mean += weight * rock(1.0 - normal.z, 0.0);
          normals += weight * normal;
          weights += weight;
        }
      }
      normals /= weights;
      const double range = rock(0.0, 0.0) - rock(1.0, 0.0);
      EXPECT_NEAR(rock(1.0 - normals.z, 1.0 - glm::length(normals)), mean / weights, 0.12 * std::abs(range))
          << variance << ' ' << slope;
    }
  }
}

TEST(MeanCosine, OfASmoothSurfaceIsTheCosineWhereThereIsLight) {
  for (double angle = 0.0; angle < 3.2; angle += 0.01) {
    const glm::dvec3 sun(std::sin(angle), 0.0, std::cos(angle));
    EXPECT_NEAR(f64::mean_cosine({0.0, 0.0, 1.0}, sun), std::max(std::cos(angle), 0.0), 1e-12);
  }
}

TEST(GroundColor, IsTheSameNorthAndSouth) {
  f64::Bands b = bands();
  b.sea = {0.01, 0.02, 0.05};
  for (double sine = 0.0; sine <= 1.0; sine += 0.05) {
    for (const double height : {-0.01, 0.01, 0.05}) {
      EXPECT_EQ(f64::ground_color(height, 0.1, 0.0, sine, 0.3, b), f64::ground_color(height, 0.1, 0.0, -sine, 0.3, b));
    }
  }
}

}  // namespace
}  // namespace terrella
