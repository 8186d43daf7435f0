#include <gtest/gtest.h>

#include "formulas/formulas.hpp"

namespace terrella {
namespace {

TEST(DiscOfSun, IsWholeInsideAndNothingOutsideOfItsRadius) {
  EXPECT_EQ(f64::disc_of_sun(0.0, 0.01, 0.001), 1.0);
  EXPECT_EQ(f64::disc_of_sun(0.0089, 0.01, 0.001), 1.0);
  EXPECT_DOUBLE_EQ(f64::disc_of_sun(0.01, 0.01, 0.001), 0.5);
  EXPECT_EQ(f64::disc_of_sun(0.0111, 0.01, 0.001), 0.0);
}

TEST(GlareOfSun, FallsFromOneToNothing) {
  EXPECT_EQ(f64::glare_of_sun(0.0, 0.01, 0.5), 1.0);
  double before = 1.0;
  for (double away = 0.001; away < 0.5; away += 0.001) {
    const double glare = f64::glare_of_sun(away, 0.01, 0.5);
    ASSERT_LT(glare, before);
    ASSERT_GE(glare, 0.0);
    before = glare;
  }
  EXPECT_EQ(f64::glare_of_sun(0.5, 0.01, 0.5), 0.0);
  EXPECT_EQ(f64::glare_of_sun(9.0, 0.01, 0.5), 0.0);
}

}  // namespace
}  // namespace terrella
