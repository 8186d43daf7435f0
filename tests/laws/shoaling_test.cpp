// Waves that run up a shore.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

// Wavenumber times depth over ground, from the same in deep water, by Newton's method: x tanh x = depth.
double dispersed(double depth) {
  double x = std::max(depth, std::sqrt(depth));
  for (int i = 0; i < 60; ++i) x -= (x * std::tanh(x) - depth) / (std::tanh(x) + x / std::pow(std::cosh(x), 2));
  return x;
}

TEST(Shoaling, ShortensWavesAsWaterDoes) {
  for (double depth = 0.065; depth < 8.0; depth *= 1.1)
    EXPECT_NEAR(f64::shortened(depth) * depth / dispersed(depth), 1.0, 0.05) << depth;
  EXPECT_EQ(f64::shortened(0.0), 1.0);
}

TEST(Shoaling, PhasesGainWhatWavesAreShorter) {
  for (double depth = 0.001; depth < 6.0; depth *= 1.07) {
    const double step = 1e-5 * depth;
    const double gained = (f64::gained_phase(depth - step) - f64::gained_phase(depth + step)) / (2.0 * step);
    EXPECT_NEAR(gained, f64::shortened(depth) - 1.0, 1e-4) << depth;
  }
  EXPECT_NEAR(f64::gained_phase(10.0), 0.0, 1e-8);
}

// A plane shore that rises to the north.
struct PlaneShore {
  double slope, waterline;  // radii north of the anchor

  [[nodiscard]] f64::Shore at(const glm::dvec2& arcs, double felt_depth) const {
    const double per_slope = 1.0 / 0.03;
    return {slope * (waterline - arcs.y), {0.0, slope * per_slope}, per_slope, felt_depth};
  }
};

f64::ShortWave any_wave(Places& places, double felt_depth) {
  const double angle = places.between(-1.0, 1.0);
  const double wavenumber = places.between(1e5, 1e6), amplitude = 0.02 / wavenumber;
  return {
      {std::sin(angle), std::cos(angle)},        wavenumber, places.between(-3.1, 3.1), amplitude, 0.7 * amplitude, 0.0,
      f64::gained_phase(wavenumber * felt_depth)};
}

constexpr double felt_depth = 2e-5;

// As a place of a beach has it: felt and held by the ground.
f64::WaveSum sum_at(const PlaneShore& shore, const f64::ShortWave& wave, const glm::dvec2& arcs) {
  const f64::Shore ground = shore.at(arcs, felt_depth);
  f64::WaveSum sum = f64::no_waves();
  f64::add_short_wave(sum, f64::ashore(f64::course_of(wave, arcs), wave, ground), wave, 1.0);
  return f64::held_ashore(sum, {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, ground.depth, {0.0, shore.slope, 0.0}, 4e-7);
}

TEST(Shoaling, SlopesAreDerivativesOnABeach) {
  Places places(3U);
  for (int i = 0; i < 300; ++i) {
    const PlaneShore shore = {places.between(0.01, 0.06), places.between(1e-5, 2e-4)};
    const f64::ShortWave wave = any_wave(places, felt_depth);
    const glm::dvec2 at = {0.0, shore.waterline - places.between(-0.4, 20.0) * 1e-7 / shore.slope};
    const double step = 1e-4 / wave.wavenumber;
    const f64::WaveSum sum = sum_at(shore, wave, at);
    const auto height = [&](double east, double north) {
      return sum_at(shore, wave, at + glm::dvec2(east, north)).height;
    };
    EXPECT_NEAR(sum.slope.x, (height(step, 0.0) - height(-step, 0.0)) / (2.0 * step), 1e-6);
    EXPECT_NEAR(sum.slope.y, (height(0.0, step) - height(0.0, -step)) / (2.0 * step), 2e-5);
  }
}

// From wherever before the shore a wave comes, it arrives nearly along the slope.
TEST(Shoaling, TurnsWavesToTheShore) {
  const PlaneShore shore = {0.03, 1e-4};
  for (const double from : {-1.0, -0.4, 0.2, 0.7, 1.0}) {
    const f64::ShortWave wave = {{std::sin(from), std::cos(from)},   2e5, 0.0, 1e-8, 0.0, 0.0,
                                 f64::gained_phase(2e5 * felt_depth)};
    const auto heading = [&](double depth) {
      const glm::dvec2 at = {0.0, shore.waterline - depth / shore.slope};
      const glm::dvec2 d = f64::ashore(f64::course_of(wave, at), wave, shore.at(at, felt_depth)).direction;
      return std::atan2(d.x, d.y);
    };
    EXPECT_NEAR(heading(2.1e-5), from, 1e-6);  // where it is deep
    EXPECT_LT(std::abs(heading(5e-6)), 0.9 * std::abs(from));
    EXPECT_LT(std::abs(heading(4e-7)), 0.3 * std::abs(from));
    EXPECT_NEAR(heading(-1e-8), from, 1e-6);  // as a sheet over the land
  }
}

TEST(Shoaling, BeginsWithoutAJump) {
  Places places(5U);
  const PlaneShore shore = {0.03, 2e-3};
  for (int i = 0; i < 100; ++i) {
    const f64::ShortWave wave = any_wave(places, felt_depth);
    const auto height = [&](double depth) {
      return sum_at(shore, wave, {0.0, shore.waterline - depth / shore.slope}).height / wave.amplitude;
    };
    EXPECT_NEAR(height(felt_depth * (1.0 - 1e-9)), height(felt_depth * (1.0 + 1e-9)), 1e-4);
    // It is at least a quarter of the wave's length: nor does it change its direction or length by much.
    EXPECT_LT(f64::shortened(std::max(wave.wavenumber * felt_depth, 0.5 * std::numbers::pi)), 1.05);
  }
}

TEST(Surf, LeavesNoWaveOnLand) {
  EXPECT_EQ(f64::left_ashore(1.0, 1.0), 1.0);
  EXPECT_EQ(f64::left_ashore(-0.12, 1.0), 0.0);
  EXPECT_NEAR(f64::left_ashore(0.0, 1.0), 0.19, 1e-12);
  EXPECT_LT(f64::left_ashore(0.5, 1.0), f64::left_ashore(0.6, 1.0));
}

// Behind a crest foam fades until the next one comes; none lies far before it.
TEST(Surf, FoamFadesBehindItsCrest) {
  double last = 1.0, sum = 0.0;
  const int steps = 2000;
  for (int i = 0; i < steps; ++i) {
    const double since = 2.0 * std::numbers::pi * (i + 0.5) / steps;
    const double left = f64::foam_left(std::cos(since), std::sin(since));
    sum += left / steps;
    if (since < 2.0 * std::numbers::pi - 0.51) {
      EXPECT_LE(left, last + 1e-12) << since;
    }
    last = left;
  }
  EXPECT_NEAR(sum, f64::mean_foam_left, 0.01);
}

TEST(Surf, IsWhereCrestsAreHighBesideTheDepth) {
  f64::WaveSum sum = f64::no_waves();
  sum.height = 0.1;
  const auto surf = [&](double depth, double unseen) { return f64::surf_part(sum, depth, unseen, 0.4); };
  EXPECT_GT(surf(0.1, 0.0), 0.99);
  EXPECT_LT(surf(0.4, 0.0), 0.01);
  EXPECT_GT(surf(0.3, 0.01), surf(0.3, 0.0) + 0.1);  // by chance, of waves that are not shown
  // From afar as much of it is white as on average.
  sum.height = 0.0;
  EXPECT_NEAR(surf(0.0, 1.0), 0.5 * f64::mean_foam_left, 1e-3);
}

TEST(Surf, FoamIsTornWhereThereIsLessOfIt) {
  double thick = 0.0, thin = 0.0;
  for (int i = 0; i < 100; ++i) {
    const f64::FoamLace lace = {-0.99 + 0.02 * i, 1.0};
    thick += f64::laced(0.9, lace) / 100.0;
    thin += f64::laced(0.2, lace) / 100.0;
    EXPECT_EQ(f64::laced(0.0, lace), 0.0);
    EXPECT_EQ(f64::laced(0.3, {lace.noise, 0.0}), 0.3);
  }
  EXPECT_GT(thick, 0.6);
  EXPECT_LT(thin, 0.1);
}

}  // namespace
}  // namespace terrella
