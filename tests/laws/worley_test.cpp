#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

f64::Worley worley(const glm::dvec3& q, unsigned seed = 5U) { return f64::worley_noise(glm::ivec3(0), q, seed); }

TEST(Worley, NearestComesFirstAndIsWithinACellsDiagonal) {
  Places places(261U);
  double highest = 0.0, sum = 0.0;
  const int count = 30'000;
  for (int i = 0; i < count; ++i) {
    const f64::Worley w = worley(places.in_cube(100.0));
    ASSERT_GE(w.nearest, 0.0);
    ASSERT_LE(w.nearest, w.second);
    ASSERT_LE(w.nearest, std::sqrt(3.0));
    highest = std::fmax(highest, w.nearest);
    sum += w.nearest;
  }
  // Points scattered evenly, but one in each cell: a little nearer than the 0.554 of points without cells.
  EXPECT_NEAR(sum / count, 0.53, 0.03);
  EXPECT_GT(highest, 1.0);
}

TEST(Worley, ChangesNoFasterThanThePlaceMoves) {
  Places places(262U);
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 q = places.in_cube(50.0);
    const double length = std::pow(10.0, places.between(-6.0, 0.0));
    const glm::dvec3 step = length * places.on_sphere();
    ASSERT_LE(std::fabs(worley(q + step).nearest - worley(q).nearest), length * (1.0 + 1e-9));
  }
}

TEST(Worley, GradientIsTheDerivativeOfTheNearest) {
  Places places(263U);
  int held = 0;
  for (int i = 0; i < 10'000; ++i) {
    const glm::dvec3 q = places.in_cube(50.0), along = places.on_sphere();
    const f64::Worley w = worley(q);
    ASSERT_NEAR(glm::length(w.gradient), 1.0, 1e-12);
    if (w.second - w.nearest < 1e-4 || w.nearest < 1e-2) continue;  // next to an edge or a point
    ++held;
    const double h = 1e-6;
    ASSERT_NEAR(glm::dot(w.gradient, along),
                (worley(q + h * along).nearest - worley(q - h * along).nearest) / (2.0 * h), 1e-4);
  }
  EXPECT_GT(held, 9000);
}

TEST(Worley, MissesNoPointThatIsNearer) {
  // The points of seven cells around, told one by one: at a point F1 is 0.
  Places places(264U);
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 q = places.in_cube(1.0);
    double least = 100.0, next = 100.0;
    for (int x = -4; x <= 4; ++x) {
      for (int y = -4; y <= 4; ++y) {
        for (int z = -4; z <= 4; ++z) {
          const glm::dvec3 point =
              glm::dvec3(x, y, z) + (f64::hash_parts(f64::hash_cell({x, y, z}, 5U)) + 0.5) / 1024.0;
          ASSERT_EQ(worley(point).nearest, 0.0);
          const double distance = glm::distance(point, q);
          next = std::fmin(next, std::fmax(least, distance));
          least = std::fmin(least, distance);
        }
      }
    }
    ASSERT_NEAR(worley(q).nearest, least, 1e-12);
    ASSERT_NEAR(worley(q).second, next, 1e-12);
  }
}

TEST(Worley, IsTheSameFromWhicheverCellItIsToldAndAnotherBySeed) {
  Places places(265U);
  for (int i = 0; i < 1000; ++i) {
    const glm::ivec3 cell(places.in_cube(1000.0));
    const glm::dvec3 q = places.in_cube(3.0);
    ASSERT_NEAR(f64::worley_noise(cell, q, 5U).nearest, worley(glm::dvec3(cell) + q).nearest, 1e-9);
    ASSERT_NE(worley(q, 5U).nearest, worley(q, 6U).nearest);
  }
}

}  // namespace
}  // namespace terrella
