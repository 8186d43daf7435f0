#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

TEST(Perpendicular, IsAUnitVectorAtRightAnglesAtThePolesToo) {
  test::Places places(331U);
  const auto expect_perpendicular = [](const glm::dvec3& n) {
    const glm::dvec3 p = f64::perpendicular(n);
    ASSERT_NEAR(glm::length(p), 1.0, 1e-14);
    ASSERT_NEAR(glm::dot(p, n), 0.0, 1e-14);
  };
  for (int i = 0; i < 10'000; ++i) expect_perpendicular(places.on_sphere());
  for (const double side : {1.0, -1.0}) {
    expect_perpendicular({0.0, 0.0, side});
    expect_perpendicular({0.0, side, 0.0});
    expect_perpendicular({side, 0.0, 0.0});
  }
}

TEST(Perpendicular, ChangesWithoutAStepOnEitherSideOfTheEquator) {
  test::Places places(332U);
  for (int i = 0; i < 10'000; ++i) {
    glm::dvec3 a = places.on_sphere();
    if (i % 3 == 0) a = glm::normalize(glm::dvec3(1e-4 * a.x, 1e-4 * a.y, a.z));  // next to a pole
    const glm::dvec3 b = glm::normalize(a + 1e-6 * places.on_sphere());
    if (a.z * b.z <= 0.0) continue;
    // At the equator it turns fastest, twice as far as its argument moves.
    ASSERT_LT(glm::distance(f64::perpendicular(a), f64::perpendicular(b)), 3e-6);
  }
}

}  // namespace
}  // namespace terrella
