#include <gtest/gtest.h>

#include <vector>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

TEST(OctaveSum, IsTheMeanByAmplitude) {
  f64::OctaveSum s = f64::no_octaves();
  EXPECT_EQ(f64::octave_mean(s), 0.0);
  f64::add_octave(s, 0.8, 0.5);
  EXPECT_EQ(f64::octave_mean(s), 0.8);
  f64::add_octave(s, 0.2, 0.5);
  f64::add_octave(s, 0.4, 0.5);
  EXPECT_NEAR(f64::octave_mean(s), (0.8 + 0.5 * 0.2 + 0.25 * 0.4) / 1.75, 1e-15);
}

TEST(LayerValue, IsHalfTheNoiseOrARidge) {
  EXPECT_EQ(f64::layer_value(-1.0, false, 1e30), 0.0);
  EXPECT_EQ(f64::layer_value(0.5, false, 1e30), 0.75);
  EXPECT_EQ(f64::layer_value(-0.25, true, 1e30), 0.75);
  EXPECT_EQ(f64::layer_value(0.25, true, 1e30), 0.75);
  EXPECT_EQ(f32::layer_value(0.25F, true, 1e30F), 0.75F);
  EXPECT_EQ(f64::layer_value(0.0, true, 1e30), 1.0);
  EXPECT_EQ(f64::layer_slope(0.25, true, 1e30), -1.0);
  EXPECT_EQ(f64::layer_slope(-0.25, true, 1e30), 1.0);
  EXPECT_NEAR(f64::layer_value(-0.25, true, 3.0), 1.0 - 0.25 * std::tanh(0.75), 1e-15);
}

TEST(TurnedNoiseBend, IsTheDerivativeOfTheGradient) {
  Places places(251U);
  for (int i = 0; i < 3000; ++i) {
    const glm::dvec3 q = places.in_cube(20.0);
    const double angle = places.between(0.0, 6.28), h = 1e-7;
    const glm::dvec2 turn(std::cos(angle), std::sin(angle));
    const glm::dmat3 bend = f64::turned_noise_bend(glm::ivec3(3, -2, 7), q, turn, 3U);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0.0);
      step[axis] = h;
      const glm::dvec3 change = f64::turned_noise(glm::ivec3(3, -2, 7), q + step, turn, 3U).gradient -
                                f64::turned_noise(glm::ivec3(3, -2, 7), q - step, turn, 3U).gradient;
      ASSERT_LT(glm::distance(bend[axis], change / (2.0 * h)), 2e-5);  // the gradient's own bends have edges
    }
  }
}

struct FlowSum {
  double value = 0.0;
  f64::Flow flow = f64::no_flow();
};

// Flow noise (18) with the octaves' own offsets and seeds.
FlowSum flow_at(const glm::dvec3& p, double strength, int octaves) {
  FlowSum s;
  double amplitude = 1.0, frequency = 1.5;
  for (int i = 0; i < octaves; ++i) {
    const glm::dvec2 turn(std::cos(0.7 * i), std::sin(0.7 * i));
    const glm::dvec3 place = f64::flow_place(p, frequency, strength, s.flow.warp, i, 9U);
    const f64::Noise n = f64::turned_noise(glm::ivec3(0), place, turn, f64::layer_seed(i, 9U));
    const glm::dmat3 bend = f64::turned_noise_bend(glm::ivec3(0), place, turn, f64::layer_seed(i, 9U));
    f64::add_flow_octave(s.flow, n, bend, amplitude, frequency, strength);
    s.value += amplitude * n.value;
    amplitude *= 0.5;
    frequency *= 2.1;
  }
  return s;
}

TEST(FlowOctaves, SlopeIsTheDerivativeThroughAllThatStirs) {
  Places places(252U);
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 p = places.in_cube(5.0), along = places.on_sphere();
    const double h = 1e-6;
    const double change = (flow_at(p + h * along, 0.3, 5).value - flow_at(p - h * along, 0.3, 5).value) / (2.0 * h);
    const double slope = glm::dot(flow_at(p, 0.3, 5).flow.slope, along);
    worst = std::fmax(worst, std::fabs(slope - change) / (1.0 + std::fabs(change)));
  }
  EXPECT_LT(worst, 1e-3);  // differences themselves are no better: five octaves of stirring bend within 1e-3 cells
}

TEST(FlowOctaves, WarpIsThatOfTheCloudsLayersAndOnlyOfThoseBefore) {
  Places places(253U);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 p = places.in_cube(5.0);
    glm::dvec3 warp(0.0);
    double sum = 0.0, plain = 0.0, amplitude = 1.0, frequency = 1.5;
    for (int k = 0; k < 4; ++k) {
      const glm::dvec2 turn(std::cos(0.7 * k), std::sin(0.7 * k));
      sum += f64::flow_layer(f64::flow_place(p, frequency, 0.3, warp, k, 9U), amplitude, turn, k, 9U, warp);
      plain += amplitude *
               f64::turned_noise(glm::ivec3(0), p * frequency + f64::layer_offset(k, 9U), turn, f64::layer_seed(k, 9U))
                   .value;
      amplitude *= 0.5;
      frequency *= 2.1;
    }
    ASSERT_NEAR(flow_at(p, 0.3, 4).value, sum, 1e-12);
    ASSERT_LT(glm::distance(flow_at(p, 0.3, 4).flow.warp, warp), 1e-12);
    ASSERT_NEAR(flow_at(p, 0.0, 4).value, plain, 1e-12);
    ASSERT_EQ(flow_at(p, 0.3, 1).value, flow_at(p, 0.0, 1).value);
    ASSERT_LE(std::fabs(sum), 1.02 * 1.875);
  }
}

}  // namespace
}  // namespace terrella
