#include <gtest/gtest.h>

#include "formulas/formulas.hpp"

namespace terrella {
namespace {

TEST(NightShare, IsNoneByDayAndAllInTheNight) {
  EXPECT_EQ(f64::night_share(f64::lights_on), 0.0);
  EXPECT_EQ(f64::night_share(1.0), 0.0);
  EXPECT_EQ(f64::night_share(-0.12), 1.0);
  EXPECT_EQ(f64::night_share(-1.0), 1.0);
  EXPECT_NEAR(f64::night_share(-0.03), 0.5, 1e-12);
  for (double climb = -0.2; climb < 0.2; climb += 1e-3) {
    const double fall = f64::night_share(climb) - f64::night_share(climb + 1e-3);
    EXPECT_GE(fall, 0.0);
    EXPECT_LT(fall, 0.01);
  }
}

}  // namespace
}  // namespace terrella
