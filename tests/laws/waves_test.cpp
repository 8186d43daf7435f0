#include <gtest/gtest.h>

#include <vector>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

std::vector<f64::Wave> sea(int count, double steepness, unsigned seed) {
  Places places(seed);
  std::vector<f64::Wave> waves;
  for (int i = 0; i < count; ++i) {
    f64::Wave wave;
    wave.origin = places.on_sphere();
    wave.wavenumber = places.between(20.0, 120.0);
    wave.amplitude = 1.0 / (wave.wavenumber * count);
    wave.phase = places.between(-3.1, 3.1);
    wave.pinch = steepness * wave.amplitude;
    waves.push_back(wave);
  }
  return waves;
}

f64::WaveSum sum_at(const std::vector<f64::Wave>& waves, const glm::dvec3& v, const f64::Frame& frame) {
  f64::WaveSum sum = f64::no_waves();
  for (const f64::Wave& wave : waves) f64::add_wave(sum, v, frame, wave, 1.0);
  return sum;
}

glm::dvec3 surface(const std::vector<f64::Wave>& waves, const glm::dvec3& v) {
  const f64::Frame frame = f64::frame_at(v);
  return v + f64::wave_offset(v, frame, sum_at(waves, v, frame));
}

// In planet axes, not of unit length.
glm::dvec3 normal_by_differences(const std::vector<f64::Wave>& waves, const glm::dvec3& v, const f64::Frame& frame) {
  const double h = 1e-5;
  const auto along = [&](const glm::dvec3& e) {
    return (surface(waves, std::cos(h) * v + std::sin(h) * e) - surface(waves, std::cos(h) * v - std::sin(h) * e)) /
           (2.0 * h);
  };
  return glm::cross(along(frame.east), along(frame.north));
}

TEST(Waves, NormalAndJacobianAreExact) {
  Places places(31U);
  for (const double steepness : {0.0, 0.5, 0.9}) {
    const auto waves = sea(8, steepness, 7U);
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec3 v = places.on_sphere();
      const f64::Frame frame = f64::frame_at(v);
      const glm::dvec3 n = f64::wave_normal(sum_at(waves, v, frame));
      const glm::dvec3 world = n.x * frame.east + n.y * frame.north + n.z * v;
      ASSERT_LT(glm::distance(world, normal_by_differences(waves, v, frame)), 2e-6) << steepness;
    }
  }
}

TEST(Waves, OneWaveHasItsAmplitudeAndLength) {
  const f64::Wave wave = sea(1, 0.0, 3U)[0];
  const glm::dvec3 side = f64::perpendicular(wave.origin);
  double highest = 0.0;
  int crossings = 0;
  double before = 0.0;
  const double start = 0.7, end = 2.2;
  for (double theta = start; theta < end; theta += 1e-4) {
    const glm::dvec3 v = std::cos(theta) * wave.origin + std::sin(theta) * side;
    const double height = sum_at({wave}, v, f64::frame_at(v)).height;
    highest = std::fmax(highest, height);
    if (before < 0.0 && height >= 0.0) ++crossings;
    before = height;
  }
  EXPECT_NEAR(highest, wave.amplitude, 1e-3 * wave.amplitude);
  EXPECT_NEAR(crossings, (end - start) * wave.wavenumber / (2.0 * std::numbers::pi), 1.0);
}

TEST(Waves, DoNotFoldWhenThePinchesSumToLessThanOne) {
  Places places(32U);
  const auto waves = sea(12, 0.95, 5U);  // amplitudes times wavenumbers sum to 1
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 v = places.on_sphere();
    ASSERT_GT(f64::wave_normal(sum_at(waves, v, f64::frame_at(v))).z, 0.0);
  }
}

TEST(Waves, FadeAtTheirOriginAndItsAntipode) {
  const auto waves = sea(1, 0.9, 9U);
  for (const double side : {1.0, -1.0}) {
    const glm::dvec3 v = side * waves[0].origin;
    const f64::WaveSum sum = sum_at(waves, v, f64::frame_at(v));
    EXPECT_EQ(sum.height, 0.0);
    EXPECT_EQ(glm::length(sum.shift), 0.0);
    EXPECT_TRUE(std::isfinite(f64::wave_normal(sum).z));
  }
}

TEST(Waves, HeldBackByShallowsKeepTheirExactNormal) {
  Places places(33U);
  const auto waves = sea(6, 0.8, 2U);
  const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, 0.5, 0.8));
  const auto factor = [&](const glm::dvec3& v) { return 0.5 + 0.4 * std::sin(3.0 * glm::dot(v, axis)); };
  const auto point = [&](const glm::dvec3& v) {
    const f64::Frame f = f64::frame_at(v);
    return v + f64::wave_offset(v, f, f64::attenuate(sum_at(waves, v, f), factor(v), glm::dvec2(0.0)));
  };
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 v = places.on_sphere();
    const f64::Frame f = f64::frame_at(v);
    const double slope = 1.2 * std::cos(3.0 * glm::dot(v, axis));
    const glm::dvec2 slopes(slope * glm::dot(axis, f.east), slope * glm::dot(axis, f.north));
    const glm::dvec3 n = f64::wave_normal(f64::attenuate(sum_at(waves, v, f), factor(v), slopes));
    const double h = 1e-5;
    const auto along = [&](const glm::dvec3& e) {
      return (point(std::cos(h) * v + std::sin(h) * e) - point(std::cos(h) * v - std::sin(h) * e)) / (2.0 * h);
    };
    const glm::dvec3 expected = glm::cross(along(f.east), along(f.north));
    ASSERT_LT(glm::distance(n.x * f.east + n.y * f.north + n.z * v, expected), 2e-6);
  }
}

TEST(Frame, IsRightHandedWithItsPlaceUp) {
  Places places(34U);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 v = places.on_sphere();
    const f64::Frame f = f64::frame_at(v);
    ASSERT_LT(glm::distance(glm::cross(f.east, f.north), v), 1e-12);
    ASSERT_NEAR(glm::length(f.east), 1.0, 1e-12);
    ASSERT_NEAR(glm::dot(f.east, v), 0.0, 1e-12);
  }
}

TEST(WaveWeight, ShowsAllOfWhatHasFourSamplesAWavelengthAndNothingUnderTwo) {
  const double wavelength = 0.03, wavenumber = 2.0 * std::numbers::pi / wavelength;
  EXPECT_EQ(f64::wave_weight(wavenumber, 0.249 * wavelength), 1.0);
  EXPECT_NEAR(f64::wave_weight(wavenumber, 0.375 * wavelength), 0.5, 1e-12);
  EXPECT_EQ(f64::wave_weight(wavenumber, 0.501 * wavelength), 0.0);
}

// Ground that rises along an axis: the water's depth at v is depth(v), and the ground's slope is the gradient of
// -depth.
TEST(HeldByGround, SlopesAndStretchesAreTheDerivativesOfWhatIsHeld) {
  Places places(35U);
  const auto waves = sea(6, 0.8, 4U);
  const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, 0.5, 0.8));
  const double whole = 0.02;
  const auto depth = [&](const glm::dvec3& v) { return 0.01 + 0.012 * std::sin(3.0 * glm::dot(v, axis)); };
  const auto held = [&](const glm::dvec3& v) {
    const f64::Frame f = f64::frame_at(v);
    const double slope = -0.036 * std::cos(3.0 * glm::dot(v, axis));
    const glm::dvec2 ground(slope * glm::dot(axis, f.east), slope * glm::dot(axis, f.north));
    return f64::held_by_ground(sum_at(waves, v, f), depth(v), ground, whole);
  };
  const auto moved = [&](const glm::dvec3& v) { return v + f64::wave_offset(v, f64::frame_at(v), held(v)); };
  int partly = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 v = places.on_sphere();
    if (depth(v) > 0.0 && depth(v) < whole) ++partly;
    const f64::Frame f = f64::frame_at(v);
    const f64::WaveSum sum = held(v);
    const double h = 1e-5;
    for (int side = 0; side < 2; ++side) {
      const glm::dvec3 e = side == 0 ? f.east : f.north;
      const glm::dvec3 ahead = std::cos(h) * v + std::sin(h) * e, back = std::cos(h) * v - std::sin(h) * e;
      const glm::dvec3 change = (moved(ahead) - moved(back)) / (2.0 * h);
      // The tangents that wave_normal takes the product of.
      const double along = 1.0 + sum.height;
      const glm::dvec3 expected = side == 0
                                      ? (along + sum.stretch_ee) * f.east + sum.stretch_ne * f.north + sum.slope.x * v
                                      : sum.stretch_en * f.east + (along + sum.stretch_nn) * f.north + sum.slope.y * v;
      ASSERT_LT(glm::distance(change, expected), 2e-6);
    }
  }
  EXPECT_GT(partly, 500);
}

TEST(HeldByGround, LeavesDeepWaterAloneAndHasNoWavesOnLand) {
  const auto waves = sea(6, 0.8, 4U);
  const glm::dvec3 v = glm::normalize(glm::dvec3(1.0, 2.0, 3.0));
  const f64::WaveSum free = sum_at(waves, v, f64::frame_at(v));
  const f64::WaveSum deep = f64::held_by_ground(free, 0.02, {0.3, -0.2}, 0.02);
  EXPECT_EQ(deep.height, free.height);
  EXPECT_EQ(deep.slope, free.slope);
  EXPECT_EQ(deep.stretch_en, free.stretch_en);
  const f64::WaveSum half = f64::held_by_ground(free, 0.01, {0.0, 0.0}, 0.02);
  EXPECT_NEAR(half.height, 0.5 * free.height, 1e-15);
  for (const double depth : {0.0, -0.01}) {
    const f64::WaveSum land = f64::held_by_ground(free, depth, {0.3, -0.2}, 0.02);
    EXPECT_EQ(land.height, 0.0);
    EXPECT_EQ(glm::length(land.shift), 0.0);
    EXPECT_EQ(f64::wave_normal(land), glm::dvec3(0.0, 0.0, 1.0));
  }
}

}  // namespace
}  // namespace terrella
