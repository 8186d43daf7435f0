#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

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

TEST(GlareOfSun, IsAThirdLessAtTheDiscsEdgeAndFallsWithTheSquareFarFromIt) {
  EXPECT_NEAR(f64::glare_of_sun(0.01, 0.01, 1e9), 2.0 / 3.0, 1e-9);
  EXPECT_NEAR(f64::glare_of_sun(2.0, 0.01, 1e9) / f64::glare_of_sun(4.0, 0.01, 1e9), 4.0, 1e-3);
  EXPECT_NEAR(f64::glare_of_sun(0.25, 0.01, 0.5) / f64::glare_of_sun(0.25, 0.01, 1e9), 0.25, 1e-9);
}

TEST(TangentFromSun, IsThatOfTheAngleForRaysOfAnyLength) {
  test::Places places(351U);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 sun = places.on_sphere(), side = f64::perpendicular(sun);
    const double angle = places.between(0.0, 1.5), size = places.between(0.1, 10.0);
    ASSERT_NEAR(f64::tangent_from_sun(size * (std::cos(angle) * sun + std::sin(angle) * side), sun), std::tan(angle),
                1e-9);
    ASSERT_EQ(f64::tangent_from_sun(-size * sun + 1e-3 * side, sun) > 100.0, true);  // behind: out of every glare
    ASSERT_GT(f64::tangent_from_sun(size * (side - 0.5 * sun), sun), 1e5);
  }
}

}  // namespace
}  // namespace terrella
