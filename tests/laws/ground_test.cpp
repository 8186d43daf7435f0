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

glm::dvec3 on_plain(double height, const f64::Bands& b) { return f64::ground_color(height, 0.0, 0.0, 0.0, b); }

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
  EXPECT_LT(glm::distance(f64::ground_color(0.01, 0.0, 1.0, 0.0, b), b.snow), 1e-9);
  const double steep = f64::ground_color(0.1, 0.5, 0.0, 0.0, b).z, flat = f64::ground_color(0.1, 0.0, 0.0, 0.0, b).z;
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

}  // namespace
}  // namespace terrella
