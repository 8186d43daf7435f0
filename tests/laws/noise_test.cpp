// The laws of the noise. Bounds stand just outside of what was measured; the measured figure is in the comment.
#include <gtest/gtest.h>

#include <set>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

f64::Noise noise(const glm::dvec3& q, unsigned seed = 1U) { return f64::simplex_noise(glm::ivec3(0), q, seed); }

TEST(SimplexNoise, HasStatedRangeMeanAndSpread) {
  Places places(11U);
  double lowest = 0.0, highest = 0.0, sum = 0.0, squares = 0.0, magnitudes = 0.0;
  const int count = 1'000'000;
  for (int i = 0; i < count; ++i) {
    const double n = noise(places.in_cube(100.0)).value;
    lowest = std::fmin(lowest, n);
    highest = std::fmax(highest, n);
    sum += n;
    squares += n * n;
    magnitudes += std::fabs(n);
  }
  const double deviation = std::sqrt(squares / count);
  RecordProperty("range", std::to_string(lowest) + " " + std::to_string(highest));
  RecordProperty("deviation", std::to_string(deviation));
  EXPECT_GT(lowest, -1.02);
  EXPECT_LT(highest, 1.02);
  EXPECT_GT(highest, 0.9);
  EXPECT_LT(lowest, -0.9);
  EXPECT_NEAR(sum / count, 0.0, 4.0 * deviation / 1000.0 + 0.001);
  EXPECT_GT(deviation, 0.25);
  EXPECT_LT(deviation, 0.45);
  // What layer_mean takes a ridge to be: 1 - E|n|.
  EXPECT_NEAR(1.0 - magnitudes / count, f64::layer_mean(true), 0.02);
}

TEST(SimplexNoise, GradientIsTheDerivative) {
  Places places(12U);
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 q = places.in_cube(100.0);
    const f64::Noise n = noise(q);
    const double h = 1e-5;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0.0);
      step[axis] = h;
      EXPECT_NEAR(n.gradient[axis], (noise(q + step).value - noise(q - step).value) / (2.0 * h), 1e-6);
    }
  }
}

TEST(SimplexNoise, ChangesNoFasterThanItsBoundAlsoOverCellBorders) {
  Places places(13U);
  for (int i = 0; i < 200'000; ++i) {
    const glm::dvec3 q = places.in_cube(100.0);
    const double length = std::pow(10.0, places.between(-4.0, -1.0));
    const glm::dvec3 step = length * places.on_sphere();
    ASSERT_LE(std::fabs(noise(q + step).value - noise(q).value), 6.5 * length);
  }
}

TEST(SimplexNoise, IsTheSameFieldFromWhicheverCellItIsTold) {
  Places places(14U);
  for (int i = 0; i < 10'000; ++i) {
    const glm::ivec3 cell(places.in_cube(1000.0));
    const glm::dvec3 q = places.in_cube(3.0);
    const glm::dvec3 corner = glm::dvec3(cell) - (static_cast<double>(cell.x) + cell.y + cell.z) / 6.0;
    const f64::Noise near = f64::simplex_noise(cell, q, 5U), far = f64::simplex_noise(glm::ivec3(0), corner + q, 5U);
    ASSERT_NEAR(near.value, far.value, 1e-9);
    ASSERT_LT(glm::distance(near.gradient, far.gradient), 1e-8);
  }
}

TEST(SimplexNoise, PrefersNoDirection) {
  Places places(15U);
  glm::dmat3 outer(0.0);
  const int count = 300'000;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 g = noise(places.in_cube(100.0)).gradient;
    outer += glm::outerProduct(g, g) / static_cast<double>(count);
  }
  // Power along any axis is within 5 % of a third of the trace, and no two axes go together.
  const double third = (outer[0][0] + outer[1][1] + outer[2][2]) / 3.0;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(outer[axis][axis] / third, 1.0, 0.05);
    EXPECT_NEAR(outer[axis][(axis + 1) % 3] / third, 0.0, 0.05);
  }
}

TEST(SimplexNoise, SeedsAndLayersAreUnrelated) {
  Places places(16U);
  double across_seeds = 0.0, across_layers = 0.0, power = 0.0;
  for (int i = 0; i < 200'000; ++i) {
    const glm::dvec3 q = places.in_cube(20.0);
    const double a = noise(q, 1U).value;
    power += a * a;
    across_seeds += a * noise(q, 2U).value;
    const auto layer = [&](int n, double f) {
      return f64::simplex_noise(glm::ivec3(0), q * f + f64::layer_offset(n, 9U), f64::layer_seed(n, 9U)).value;
    };
    across_layers += layer(0, 1.0) * layer(1, 2.0);
  }
  EXPECT_NEAR(across_seeds / power, 0.0, 0.05);
  EXPECT_NEAR(across_layers / power, 0.0, 0.1);
}

TEST(SimplexNoise, IsFiniteFarAwayAndAtLatticePoints) {
  for (const double x : {0.0, -0.0, 1.0, -1.0, 1e6, -1e6, 1e9, -1e9}) {
    for (const double y : {0.0, 0.5, -3.0, 1e9}) {
      const f64::Noise n = noise({x, y, x});
      EXPECT_TRUE(std::isfinite(n.value) && std::isfinite(glm::length(n.gradient))) << x << " " << y;
    }
  }
}

TEST(FlowNoise, TurnsBackAfterAFullTurnAndChangesSlowly) {
  Places places(17U);
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 q = places.in_cube(50.0);
    const double angle = places.between(-7.0, 7.0);
    const auto flow = [&](double a) { return f64::flow_noise(glm::ivec3(0), q, a, 3U).value; };
    ASSERT_NEAR(flow(angle), flow(angle + 2.0 * std::numbers::pi), 1e-9);
    ASSERT_LE(std::fabs(flow(angle + 1e-4) - flow(angle)) / 1e-4, 1.1);
  }
}

TEST(FlowNoise, WithoutATurnIsSimplexNoise) {
  Places places(18U);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 q = places.in_cube(50.0);
    EXPECT_EQ(f64::flow_noise(glm::ivec3(0), q, 0.0, 3U).value, f64::simplex_noise(glm::ivec3(0), q, 3U).value);
  }
}

// What is turned towards tangents that favour an axis shows the lattice: ripples of the sea would be bricks.
TEST(FlowNoise, PrefersNoDirectionHoweverFarItIsTurned) {
  Places places(25U);
  for (double angle = 0.0; angle < 6.28; angle += 0.39) {
    glm::dmat3 squares(0.0);
    glm::dvec3 gradients(0.0);
    double sum = 0.0, of_squares = 0.0;
    const int count = 40'000;
    for (int i = 0; i < count; ++i) {
      const f64::Noise n = f64::flow_noise(glm::ivec3(0), places.in_cube(100.0), angle, 3U);
      squares += glm::outerProduct(n.gradient, n.gradient) / static_cast<double>(count);
      gradients += n.gradient / static_cast<double>(count);
      sum += n.value;
      of_squares += n.value * n.value;
    }
    // By chance the three differ by 1.5 % of their mean.
    const double mean = (squares[0][0] + squares[1][1] + squares[2][2]) / 3.0;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(squares[axis][axis], mean, 0.04 * mean) << "axis " << axis << " at " << angle;
      EXPECT_NEAR(squares[axis][(axis + 1) % 3], 0.0, 0.04 * mean) << "axes " << axis << " on at " << angle;
      EXPECT_NEAR(gradients[axis], 0.0, 0.03 * std::sqrt(mean)) << "axis " << axis << " at " << angle;
    }
    const double deviation = std::sqrt(of_squares / count);
    EXPECT_NEAR(sum / count, 0.0, 4.0 * deviation / std::sqrt(count) + 0.001) << "at " << angle;
    EXPECT_GT(deviation, 0.25);
    EXPECT_LT(deviation, 0.45);
  }
}

TEST(FlowNoise, GradientIsTheDerivative) {
  Places places(19U);
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 q = places.in_cube(20.0);
    const double angle = places.between(0.0, 6.28), h = 1e-5;
    const f64::Noise n = f64::flow_noise(glm::ivec3(0), q, angle, 3U);
    const glm::dvec3 step = h * places.on_sphere();
    const double change = f64::flow_noise(glm::ivec3(0), q + step, angle, 3U).value -
                          f64::flow_noise(glm::ivec3(0), q - step, angle, 3U).value;
    ASSERT_NEAR(glm::dot(n.gradient, step) / h, change / (2.0 * h), 1e-6);
  }
}

TEST(HashDirection, IsAUnitVectorWithAPerpendicular) {
  for (unsigned i = 0; i < 100'000U; ++i) {
    const glm::dvec3 d = f64::hash_direction(i * 2654435761U);
    ASSERT_NEAR(glm::length(d), 1.0, 1e-12);
    const glm::dvec3 p = f64::perpendicular(d);
    ASSERT_NEAR(glm::dot(d, p), 0.0, 1e-9);
    ASSERT_NEAR(glm::length(p), 1.0, 1e-9);
  }
}

TEST(AmplitudeSum, IsThatOfTheLayers) {
  for (const double persistence : {0.0, 0.3, 0.999, 0.9995, 1.0, 1.0005, 1.001, 1.5}) {
    double sum = 0.0, amplitude = 1.0;
    for (int count = 1; count <= 24; ++count, amplitude *= persistence) {
      sum += amplitude;
      // Near 1 the quotient would lose its digits: there all are taken for as strong as the first, 1.2 % too much.
      EXPECT_NEAR(f64::amplitude_sum(persistence, count), sum, 0.012 * sum);
    }
  }
}

// What two layers had in common would show as the same hills twice, on one planet or on the next.
TEST(LayerSeed, IsAnotherForEachLayerOfEachPlanet) {
  std::set<unsigned> seeds;
  for (unsigned planet = 0; planet < 100; ++planet) {
    for (int layer = 0; layer < 32; ++layer) seeds.insert(f64::layer_seed(layer, planet));
  }
  EXPECT_EQ(seeds.size(), 3200U);
}

}  // namespace
}  // namespace terrella
