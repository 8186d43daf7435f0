// Laws of the noise that take many samples or many turns: its spectrum, its period, its octaves
// (tests/laws/noise_test.cpp has those of single places). Bounds stand just outside of what was measured; the figure is
// in the comment.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

double value_of_noise(const glm::dvec3& q, unsigned seed = 1U) {
  return f64::simplex_noise(glm::ivec3(0), q, seed).value;
}

TEST(NoiseLaws, SinglePrecisionIsContinuousOverCellBordersToo) {
  Places places(271U);
  for (int i = 0; i < 200'000; ++i) {
    const glm::vec3 a(places.in_cube(100.0));
    const glm::vec3 b = a + glm::vec3(std::pow(10.0, places.between(-6.0, -1.0)) * places.on_sphere());
    const double length = glm::distance(glm::dvec3(a), glm::dvec3(b));
    const float change =
        f32::simplex_noise(glm::ivec3(0), a, 1U).value - f32::simplex_noise(glm::ivec3(0), b, 1U).value;
    ASSERT_LE(std::fabs(double{change}), 6.5 * length + 2e-4);
  }
}

TEST(NoiseLaws, SteepestSlopeIsBelowItsBound) {
  Places places(272U);
  double steepest = 0.0;
  for (int i = 0; i < 500'000; ++i) {
    steepest = std::fmax(steepest, glm::length(f64::simplex_noise(glm::ivec3(0), places.in_cube(100.0), 1U).gradient));
  }
  RecordProperty("steepest", std::to_string(steepest));
  EXPECT_LT(steepest, 6.5);
  EXPECT_GT(steepest, 5.0);
}

// Power by frequency along one direction, from 0 to 4 cycles a cell in steps of 1/16, as shares of the whole; the mean
// of many lines. Hann's window keeps what is next to 0 from leaking.
constexpr int samples = 128;
constexpr double spacing = 1.0 / 8.0;  // cells

std::vector<double> spectrum_along(const glm::dvec3& direction, int lines, unsigned seed) {
  Places places(seed);
  std::vector<double> cosines(samples), sines(samples), window(samples);
  for (int i = 0; i < samples; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / samples;
    cosines[static_cast<std::size_t>(i)] = std::cos(angle);
    sines[static_cast<std::size_t>(i)] = std::sin(angle);
    window[static_cast<std::size_t>(i)] = 0.5 - 0.5 * std::cos(angle);
  }
  std::vector<double> power(samples / 2, 0.0);
  std::vector<double> values(samples);
  for (int line = 0; line < lines; ++line) {
    const glm::dvec3 start = places.in_cube(100.0);
    for (int i = 0; i < samples; ++i) {
      values[static_cast<std::size_t>(i)] =
          window[static_cast<std::size_t>(i)] * value_of_noise(start + (i * spacing) * direction);
    }
    for (std::size_t k = 0; k < power.size(); ++k) {
      double real = 0.0, imaginary = 0.0;
      for (std::size_t i = 0; i < samples; ++i) {
        real += values[i] * cosines[(i * k) % samples];
        imaginary += values[i] * sines[(i * k) % samples];
      }
      power[k] += real * real + imaginary * imaginary;
    }
  }
  double sum = 0.0;
  for (const double p : power) sum += p;
  for (double& p : power) p /= sum;
  return power;
}

double share(const std::vector<double>& power, double from, double to) {
  double sum = 0.0;
  for (std::size_t k = 0; k < power.size(); ++k) {
    const double frequency = static_cast<double>(k) / (samples * spacing);
    if (frequency >= from && frequency < to) sum += power[k];
  }
  return sum;
}

TEST(NoiseLaws, SpectrumEndsBelowTwoCyclesACell) {
  const auto power = spectrum_along(glm::normalize(glm::dvec3(0.3, 0.5, 0.8)), 1500, 273U);
  const double beyond = share(power, 1.5, 4.0);
  RecordProperty("beyond", std::to_string(beyond));
  EXPECT_LT(beyond, 0.02);
  EXPECT_GT(beyond, 1e-4);  // something is measured
}

TEST(NoiseLaws, SpectrumIsTheSameInEveryDirection) {
  const glm::dvec3 directions[] = {{1, 0, 0}, {0, 1, 0},    {0, 0, 1},      {1, 1, 0},
                                   {1, 1, 1}, {1, -1, 0.5}, {0.3, 0.5, 0.8}};
  const std::array<double, 6> edges = {0.0, 0.25, 0.5, 0.75, 1.0, 1.25};
  std::vector<std::vector<double>> spectra;
  unsigned seed = 274U;
  for (const glm::dvec3& d : directions) spectra.push_back(spectrum_along(glm::normalize(d), 1500, seed++));
  for (std::size_t band = 0; band + 1 < edges.size(); ++band) {
    double mean = 0.0;
    std::string shares;
    for (const auto& power : spectra) mean += share(power, edges[band], edges[band + 1]) / 7.0;
    for (const auto& power : spectra) {
      const double one = share(power, edges[band], edges[band + 1]);
      shares += std::to_string(one) + " ";
      EXPECT_NEAR(one / mean, 1.0, 0.08) << "band from " << edges[band];
    }
    RecordProperty("band" + std::to_string(band), shares);
  }
}

TEST(NoiseLaws, HasNoPeriodThatIsSeen) {
  // The keys of the lattice repeat after 2^32 cells along each of its axes; nothing shorter does. 289 cells, where
  // noise with a permutation polynomial repeats, among them.
  Places places(275U);
  for (const double shift : {1.0, 2.0, 7.0, 144.5, 256.0, 289.0, 512.0, 1024.0, 65536.0}) {
    for (int axis = 0; axis < 4; ++axis) {
      glm::dvec3 step(axis == 3 ? shift : 0.0);
      if (axis < 3) step[axis] = shift;
      double most = 0.0;
      for (int i = 0; i < 3000; ++i) {
        const glm::dvec3 q = places.in_cube(50.0);
        most = std::fmax(most, std::fabs(value_of_noise(q + step) - value_of_noise(q)));
      }
      EXPECT_GT(most, 1.0) << shift << " along " << axis;
    }
  }
  for (int i = 0; i < 1000; ++i) {
    const glm::ivec3 cell(places.in_cube(1e6));
    const glm::uvec3 next = glm::uvec3(cell) + glm::uvec3(0x80000000U) + glm::uvec3(0x80000000U);
    ASSERT_EQ(f64::hash_cell(cell, 3U), f64::hash_cell(glm::ivec3(next), 3U));
  }
}

TEST(NoiseLaws, OctavesAreUnrelatedAroundTheOriginToo) {
  // Without offsets of their own all octaves are 0 there. A sphere this small holds few waves of noise, so that one
  // seed says little: the mean of many does.
  for (const double radius : {0.5, 2.0}) {
    double mean = 0.0;
    const unsigned seeds = 40U;
    for (unsigned seed = 0; seed < seeds; ++seed) {
      Places places(276U + seed);
      double both = 0.0, first = 0.0, second = 0.0, first_mean = 0.0, second_mean = 0.0;
      const int count = 2000;
      for (int i = 0; i < count; ++i) {
        const glm::dvec3 p = radius * places.on_sphere();
        const auto octave = [&](int k, double f) {
          return f64::simplex_noise(glm::ivec3(0), p * f + f64::layer_offset(k, seed), f64::layer_seed(k, seed)).value;
        };
        const double a = octave(2, 1.0), b = octave(3, 2.0);
        both += a * b / count;
        first += a * a / count;
        second += b * b / count;
        first_mean += a / count;
        second_mean += b / count;
      }
      const double spreads = (first - first_mean * first_mean) * (second - second_mean * second_mean);
      mean += (both - first_mean * second_mean) / std::sqrt(spreads) / seeds;
    }
    RecordProperty("correlation_at_" + std::to_string(radius), std::to_string(mean));
    EXPECT_LT(std::fabs(mean), 0.1) << radius;
  }
  double sum = 0.0;
  for (int k = 0; k < 4; ++k) {
    sum += std::fabs(f64::simplex_noise(glm::ivec3(0), f64::layer_offset(k, 9U), f64::layer_seed(k, 9U)).value);
  }
  EXPECT_GT(sum, 0.1);
}

TEST(NoiseLaws, TurnsBackAfterAnyNumberOfTurns) {
  Places places(277U);
  double fastest = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 q = places.in_cube(50.0);
    const double angle = places.between(0.0, 6.28);
    const auto flow = [&](double a) { return f64::flow_noise(glm::ivec3(0), q, a, 3U).value; };
    for (const double turns : {-3.0, 1.0, 1000.0}) {
      ASSERT_NEAR(flow(angle), flow(angle + 2.0 * std::numbers::pi * turns), 1e-9);
    }
    fastest = std::fmax(fastest, std::fabs(flow(angle + 1e-5) - flow(angle - 1e-5)) / 2e-5);
  }
  RecordProperty("fastest", std::to_string(fastest));
  EXPECT_LT(fastest, 1.1);
  EXPECT_GT(fastest, 0.8);
}

TEST(NoiseLaws, IsTheSameOnEveryMachine) {
  // Whole numbers to the bit, values as far as machines that fuse a product and a sum agree.
  EXPECT_EQ(f64::hash_cell({1, -2, 3}, 7U), 2099052569U);
  struct Value {
    glm::dvec3 q;
    double value;
  };
  for (const Value& v :
       {Value{{0.5, 0.25, 0.125}, 0.24731208706169575}, Value{{-33.5, 70.25, 1.0}, -0.5050417351885077}}) {
    EXPECT_NEAR(f64::simplex_noise(glm::ivec3(0), v.q, 7U).value, v.value, 1e-13);
  }
}

}  // namespace
}  // namespace terrella
