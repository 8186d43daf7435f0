#include <gtest/gtest.h>

#include <cmath>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

const f64::Ice polar = {0.04, std::sin(1.2), 0.0012, 5U};

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
  EXPECT_EQ(f64::ice_height(1.0, polar), polar.sea + polar.thickness);
  EXPECT_EQ(f64::ice_height(0.0, polar), polar.sea);
  EXPECT_EQ(f64::ice_height(-0.01, polar), polar.sea - 0.01);
  EXPECT_EQ(f64::ice_height(-1.0, polar), polar.sea - 0.04);
}

TEST(Floes, AreWhereNoPointOfAnotherIsNearer) {
  test::Places places(2);
  for (int i = 0; i < 2'000; ++i) {
    const glm::dvec3 place = 15.0 * places.on_sphere();
    double nearest = 9.0, second = 9.0;
    const glm::ivec3 cell(glm::floor(place));
    for (int x = -3; x <= 3; ++x) {
      for (int y = -3; y <= 3; ++y) {
        for (int z = -3; z <= 3; ++z) {
          const glm::ivec3 beside = cell + glm::ivec3(x, y, z);
          const glm::dvec3 point = glm::dvec3(beside) + f64::hash_parts(f64::hash_cell(beside, 5U)) / 1023.0;
          const double away = glm::distance(place, point);
          second = std::min(second, std::max(nearest, away));
          nearest = std::min(nearest, away);
        }
      }
    }
    ASSERT_NEAR(f64::floe_at(place, 5U).from_rim, 0.5 * (second - nearest), 1e-12);
  }
}

TEST(Floes, LeaveNoStepInTheCover) {
  test::Places places(3);
  constexpr double step = 1e-4;
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 a = places.on_sphere();
    if (!f64::ice_near(a, polar)) continue;
    const glm::dvec3 b = glm::normalize(a + step * places.on_sphere());
    // Rims move by a radian for each radian of a place, bays and the latitude by less.
    const double change = f64::ice_cover(a, polar, 1e-4) - f64::ice_cover(b, polar, 1e-4);
    ASSERT_LE(std::abs(change), 2.0 * step);
  }
}

TEST(PolarSine, IsThatOfTheLatitudeAndNowhereFromThePoleOn) {
  EXPECT_NEAR(f64::polar_sine(30.0), 0.5, 1e-12);
  EXPECT_NEAR(f64::polar_sine(-90.0), -1.0, 1e-12);
  EXPECT_EQ(f64::polar_sine(90.0), 2.0);
}

// At its edge most floes are missing, further in cracks are left between them, and then it is whole.
TEST(Ice, ClosesUpFromItsEdgeInwards) {
  const f64::Ice wide = {0.04, 0.7, 0.0012, 5U};
  const auto covered = [&](double within) {
    int count = 0;
    for (int i = 0; i < 5000; ++i) {
      const double z = wide.sine + within, level = std::sqrt(1.0 - z * z), longitude = 1.3e-3 * i;
      if (f64::ice_cover({level * std::cos(longitude), level * std::sin(longitude), z}, wide, 1e-4) > 0.0) ++count;
    }
    return count / 5000.0;
  };
  EXPECT_EQ(covered(-0.07), 0.0);
  EXPECT_LT(covered(-0.02), 0.45);
  EXPECT_GT(covered(0.02), covered(-0.02));
  EXPECT_GT(covered(0.08), covered(0.02));
  EXPECT_EQ(covered(0.16), 1.0);
}

}  // namespace
}  // namespace terrella
