#include <gtest/gtest.h>

#include <cmath>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

const f64::Ice polar = {0.04, std::sin(1.2), 5U};

TEST(Ice, CoversThePolesAndLeavesTheRestAlone) {
  test::Places places(1);
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 direction = places.on_sphere();
    if (std::abs(direction.z) < polar.sine - 0.08) {
      ASSERT_FALSE(f64::ice_near(direction, polar));
    }
    if (!f64::ice_near(direction, polar)) continue;
    const double cover = f64::ice_cover(direction, polar, 1e-4);
    if (std::abs(direction.z) < polar.sine - 0.07) {
      ASSERT_LT(cover, 0.0);
    }
    if (std::abs(direction.z) > polar.sine + 0.06 + 0.12) {
      ASSERT_GE(cover, 0.0);  // no cracks any more
    }
  }
  f64::Ice none = polar;
  none.sine = 2.0;
  EXPECT_FALSE(f64::ice_near({0.0, 0.0, 1.0}, none));
  none = polar;
  none.sea = 0.0;  // nothing to float on
  EXPECT_FALSE(f64::ice_near({0.0, 0.0, 1.0}, none));
}

TEST(Ice, LiesALittleOverTheWaterAndEndsInASlopeUnderIt) {
  EXPECT_EQ(f64::ice_height(1.0, polar), polar.sea + f64::ice_thickness);
  EXPECT_EQ(f64::ice_height(0.0, polar), polar.sea);
  EXPECT_EQ(f64::ice_height(-0.01, polar), polar.sea - 0.01);
  EXPECT_EQ(f64::ice_height(-1.0, polar), polar.sea - 0.04);
}

}  // namespace
}  // namespace terrella
