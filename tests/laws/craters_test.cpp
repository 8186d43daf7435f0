#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

f64::Craters fresh() {
  f64::Craters c;
  c.depth = 1.0;
  c.frequency = 2.0;
  c.sizes = 8;
  c.seed = 5U;
  return c;
}

struct Relief {
  double height = 0.0;
  glm::dvec3 gradient{0.0};
};

Relief relief_at(const glm::dvec3& direction, const f64::Craters& craters, double footprint = 0.0) {
  Relief relief;
  f64::add_craters(direction, craters, footprint, relief.height, relief.gradient);
  return relief;
}

TEST(CraterShape, IsABowlWithARimThatEndsSmoothly) {
  EXPECT_EQ(f64::crater_shape(0.0).height, -1.0);
  EXPECT_EQ(f64::crater_shape(0.0).slope, 0.0);
  EXPECT_DOUBLE_EQ(f64::crater_shape(1.0).height, 0.22);
  for (const double x : {f64::crater_reach, 10.0}) {
    EXPECT_EQ(f64::crater_shape(x).height, 0.0);
    EXPECT_EQ(f64::crater_shape(x).slope, 0.0);
  }
}

TEST(CraterShape, SlopeIsTheDerivative) {
  for (double x = 1e-3; x < 2.0; x += 1e-3) {
    const double change = (f64::crater_shape(x + 1e-6).height - f64::crater_shape(x - 1e-6).height) / 2e-6;
    ASSERT_NEAR(f64::crater_shape(x).slope, change, 2e-5) << x;  // its bend jumps where bowl and rim begin
  }
}

TEST(Craters, GradientIsTheDerivativeAlongTheSphereOverBordersOfCellsToo) {
  Places places(31U);
  const f64::Craters craters = fresh();
  int dug = 0;
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 d = places.on_sphere();
    const glm::dvec3 side = glm::normalize(glm::cross(d, places.on_sphere()));
    const double h = 1e-7;
    const Relief here = relief_at(d, craters);
    const double change = relief_at(glm::normalize(d + h * side), craters).height -
                          relief_at(glm::normalize(d - h * side), craters).height;
    ASSERT_NEAR(glm::dot(here.gradient, side), change / (2.0 * h), 2e-5) << i;
    dug += here.height < 0.0 ? 1 : 0;
  }
  EXPECT_GT(dug, 2000);
}

// A crater that a cell further away than those asked for could reach would end in a cliff.
TEST(Craters, NoStepIsSteeperThanTheSteepestCrater) {
  Places places(32U);
  f64::Craters craters = fresh();
  craters.sizes = 1;
  craters.frequency = 3.0;
  const double h = 1e-6;
  double steepest = 0.0;
  for (int i = 0; i < 200'000; ++i) {
    const glm::dvec3 d = places.on_sphere();
    const glm::dvec3 side = glm::normalize(glm::cross(d, places.on_sphere()));
    const double step = relief_at(glm::normalize(d + h * side), craters).height - relief_at(d, craters).height;
    steepest = std::fmax(steepest, std::fabs(step) / h);
  }
  EXPECT_LT(steepest, 1.0);  // measured 0.974: craters overlap
}

TEST(Craters, CoverTheSphereEvenly) {
  Places places(33U);
  const f64::Craters craters = fresh();
  double sum[3] = {0.0, 0.0, 0.0};  // toward an axis, an edge and a corner of the lattice
  int count[3] = {0, 0, 0};
  for (int i = 0; i < 200'000; ++i) {
    const glm::dvec3 d = places.on_sphere(), a = glm::abs(d);
    const double most = std::max({a.x, a.y, a.z}), least = std::min({a.x, a.y, a.z});
    const int where = most > 0.9 ? 0 : least > 0.4 ? 2 : 1;
    sum[where] += relief_at(d, craters).height < -1e-4 ? 1.0 : 0.0;
    ++count[where];
  }
  const double share[] = {sum[0] / count[0], sum[1] / count[1], sum[2] / count[2]};
  for (const double part : share) EXPECT_NEAR(part, 0.16, 0.02);  // measured 0.150 to 0.175
}

TEST(Craters, FadeBeforeSamplesAreTooCoarse) {
  Places places(34U);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 d = places.on_sphere();
    EXPECT_EQ(relief_at(d, fresh(), 0.5).height, 0.0);
    EXPECT_NEAR(relief_at(d, fresh(), 1e-3).height, relief_at(d, fresh()).height, 1e-12);
  }
}

TEST(Craters, AreFiniteAtTheEndsOfEveryParameter) {
  Places places(35U);
  for (const double frequency : {0.01, 1000.0}) {
    f64::Craters c = fresh();
    c.frequency = frequency;
    c.sizes = 16;
    for (int i = 0; i < 1000; ++i) {
      const Relief r = relief_at(places.on_sphere(), c);
      ASSERT_TRUE(std::isfinite(r.height) && std::isfinite(glm::length(r.gradient)));
    }
  }
}

// What unseen_heights (src/planet/terrain.cpp) takes a size of craters for: measured 0.0055 to 0.0056 cells.
TEST(Craters, OfOneSizeDeviateAsMuchWhateverTheirSize) {
  Places places(35U);
  for (const double frequency : {4.0, 16.0, 64.0}) {
    double square = 0.0;
    constexpr int count = 200'000;
    for (int i = 0; i < count; ++i) {
      f64::Craters one = fresh();
      one.frequency = frequency;
      one.sizes = 1;
      one.seed = static_cast<unsigned>(i % 50);
      square += std::pow(frequency * relief_at(places.on_sphere(), one).height, 2.0);
    }
    EXPECT_NEAR(std::sqrt(square / count), 0.0056, 0.0003) << frequency;
  }
}

}  // namespace
}  // namespace terrella
