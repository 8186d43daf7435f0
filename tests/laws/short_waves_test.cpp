#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

f64::ShortWave any_wave(Places& places) {
  const double angle = places.between(0.0, 6.28);
  f64::ShortWave wave{};
  wave.direction = {std::cos(angle), std::sin(angle)};
  wave.wavenumber = places.between(5e3, 5e5);
  wave.phase = places.between(-3.1, 3.1);
  wave.amplitude = 0.1 / wave.wavenumber;
  wave.pinch = 0.7 * wave.amplitude;
  wave.bend = places.between(-1.5, 1.5);
  return wave;
}

f64::WaveSum sum_of(const f64::ShortWave& wave, const glm::dvec2& arcs) {
  f64::WaveSum sum = f64::no_waves();
  f64::add_short_wave(sum, f64::course_of(wave, arcs), wave, 1.0);
  return sum;
}

TEST(ShortWaves, SlopesAndStretchesAreDerivatives) {
  Places places(3U);
  for (int i = 0; i < 2000; ++i) {
    const f64::ShortWave wave = any_wave(places);
    const glm::dvec2 at = glm::dvec2(places.between(-1.0, 1.0), places.between(-1.0, 1.0)) * (200.0 / wave.wavenumber);
    const double h = 1e-4 / wave.wavenumber;
    const auto change = [&](const glm::dvec2& along) {
      const f64::WaveSum more = sum_of(wave, at + h * along), less = sum_of(wave, at - h * along);
      return glm::dvec3(more.height - less.height, more.shift.x - less.shift.x, more.shift.y - less.shift.y) /
             (2.0 * h);
    };
    const glm::dvec3 east = change({1.0, 0.0}), north = change({0.0, 1.0});
    const f64::WaveSum sum = sum_of(wave, at);
    const double slope = wave.amplitude * wave.wavenumber;
    // The slope is that of the surface, which leans as the sphere bends under what has moved aside.
    EXPECT_NEAR(sum.slope.x + sum.shift.x, east.x, 0.005 * slope);
    EXPECT_NEAR(sum.slope.y + sum.shift.y, north.x, 0.005 * slope);
    EXPECT_NEAR(sum.stretch_ee, east.y, 0.005 * slope);
    EXPECT_NEAR(sum.stretch_ne, east.z, 0.005 * slope);
    EXPECT_NEAR(sum.stretch_en, north.y, 0.005 * slope);
    EXPECT_NEAR(sum.stretch_nn, north.z, 0.005 * slope);
  }
}

TEST(ShortWaves, WeightFadesThemAsAWhole) {
  Places places(4U);
  const f64::ShortWave wave = any_wave(places);
  const glm::dvec2 at(1e-4, -2e-4);
  f64::WaveSum half = f64::no_waves();
  f64::add_short_wave(half, f64::course_of(wave, at), wave, 0.5);
  const f64::WaveSum whole = sum_of(wave, at);
  EXPECT_DOUBLE_EQ(half.height, 0.5 * whole.height);
  EXPECT_DOUBLE_EQ(half.slope.x, 0.5 * whole.slope.x);
  EXPECT_DOUBLE_EQ(half.stretch_en, 0.5 * whole.stretch_en);
}

TEST(Arcs, AreAsLongAsTheWayOverTheSphere) {
  Places places(6U);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 anchor = places.on_sphere();
    const f64::Frame axes = f64::frame_at(anchor);
    const double way = places.between(1e-9, 0.28), turn = places.between(0.0, 6.28);
    const glm::dvec3 aside = std::cos(turn) * axes.east + std::sin(turn) * axes.north;
    const glm::dvec3 offset = std::sin(way) * aside - 2.0 * std::pow(std::sin(0.5 * way), 2) * anchor;
    const glm::dvec2 arcs = f64::arcs_from_anchor(offset, axes);
    EXPECT_NEAR(arcs.x, way * std::cos(turn), 2e-5 * way);
    EXPECT_NEAR(arcs.y, way * std::sin(turn), 2e-5 * way);
  }
}

TEST(CarriedAxes, StayAtRightAnglesAlongTheSphere) {
  Places places(7U);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 anchor = places.on_sphere(), v = places.on_sphere();
    if (glm::dot(anchor, v) < -0.99) continue;
    const f64::Frame f = f64::carried_axes(f64::frame_at(anchor), anchor, v);
    EXPECT_NEAR(glm::length(f.east), 1.0, 1e-12);
    EXPECT_NEAR(glm::length(f.north), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(f.east, f.north), 0.0, 1e-12);
    EXPECT_NEAR(glm::dot(f.east, v), 0.0, 1e-12);
    EXPECT_LT(glm::distance(glm::cross(f.east, f.north), v), 1e-12);
  }
}

TEST(Regions, PartsHaveTheEnergyOfOneSeaAndChangeSmoothly) {
  Places places(8U);
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 v = places.on_sphere(), near = glm::normalize(v + 1e-6 * places.in_cube(1.0));
    const glm::dvec3 parts = f64::parts_of_regions(v);
    ASSERT_NEAR(glm::dot(parts, parts), 1.0, 1e-12);
    ASSERT_GE(std::min({parts.x, parts.y, parts.z}), 0.0);
    ASSERT_LT(glm::distance(parts, f64::parts_of_regions(near)), 1e-4);
    // Nowhere in reach of a region that lies around the other end of an axis.
    for (int axis = 0; axis < 3; ++axis) {
      if (parts[axis] > 0.0) {
        ASSERT_GT(std::abs(v[axis]), 0.5);
      }
    }
  }
  EXPECT_EQ(f64::parts_of_regions({0.9, 0.3, -0.2}), glm::dvec3(1.0, 0.0, 0.0));
}

TEST(PartBelow, IsTheNormalDistribution) {
  for (double x = -8.0; x <= 8.0; x += 0.01)
    EXPECT_NEAR(f64::part_below(x), 0.5 * std::erfc(-x / std::numbers::sqrt2), 2e-4) << x;
  EXPECT_GE(f32::part_below(-1e30F), 0.0F);
  EXPECT_LE(f32::part_below(1e30F), 1.0F);
}

f64::WaterLook plain_look() {
  f64::WaterLook look{};
  look.foam = 1.0;
  look.roughness = 0.1;
  look.refraction_index = 1.333;
  return look;
}

// As much foam where no wave is shown as on average over a sea whose waves are.
TEST(OpenWater, IsAsWhiteFromAfarAsOnAverage) {
  Places places(11U);
  const f64::Breaking breaking = {0.85, 0.05, 0.8};
  const glm::dvec3 up(0.0, 0.0, 1.0), eye(0.0, 0.0, 1.0);
  const f64::Frame frame = f64::frame_at(up);
  std::vector<f64::ShortWave> waves;
  double variance = 0.0;
  for (int i = 0; i < 60; ++i) {
    f64::ShortWave wave = any_wave(places);
    wave.amplitude = 0.03 / wave.wavenumber;
    wave.pinch = breaking.choppiness * wave.amplitude;
    variance += 0.5 * 0.03 * 0.03;
    waves.push_back(wave);
  }
  double mean = 0.0;
  constexpr int count = 20'000;
  for (int i = 0; i < count; ++i) {
    f64::WaveSum sum = f64::no_waves();
    const glm::dvec2 at(places.between(-1.0, 1.0) * 1e-3, places.between(-1.0, 1.0) * 1e-3);
    for (const f64::ShortWave& wave : waves) f64::add_short_wave(sum, f64::course_of(wave, at), wave, 1.0);
    mean +=
        f64::open_water(up, eye, false, 1.0, sum, frame, {0.0, 0.0}, breaking, {0.0, 0.0}, 1e-3, plain_look()).foam /
        count;
  }
  const double from_afar = f64::open_water(up, eye, false, 1.0, f64::no_waves(), frame, {variance, 0.0}, breaking,
                                           {0.0, 0.0}, 1e-3, plain_look())
                               .foam;
  EXPECT_GT(mean, 0.02);
  EXPECT_NEAR(from_afar, mean, 0.15 * mean);
}

// Slopes that are not shown roughen the water by their variance: that of the glitter's lobe.
TEST(OpenWater, IsRougherByTheWavesThatAreNotShown) {
  const glm::dvec3 up(0.0, 0.0, 1.0);
  const auto roughness = [&](double unseen) {
    return f64::open_water(up, up, false, 1.0, f64::no_waves(), f64::frame_at(up), {unseen, 0.0}, {0.5, 0.1, 0.0},
                           {0.0, 0.0}, 1e-3, plain_look())
        .roughness;
  };
  EXPECT_DOUBLE_EQ(roughness(0.0), 0.1);
  EXPECT_NEAR(std::pow(roughness(0.04), 4), 0.04 + 1e-4, 1e-9);
  EXPECT_EQ(roughness(10.0), 1.0);
}

// Against the mean over slopes of a normal distribution, each seen as far as it faces the eye.
TEST(OpenWater, ReflectsAsMuchAsItsWavesDoOnAverage) {
  Places places(12U);
  const glm::dvec3 up(0.0, 0.0, 1.0);
  const double r0 = f64::reflectance_at_normal(1.0, 1.333);
  for (const double deviation : {0.05, 0.15}) {
    for (const double climb : {0.05, 0.15, 0.3, 0.5, 0.8}) {
      const glm::dvec3 eye(std::sqrt(1.0 - climb * climb), 0.0, climb);
      double sum = 0.0, weights = 0.0;
      for (int i = 0; i < 40'000; ++i) {
        const double size = deviation * std::sqrt(-2.0 * std::log(places.between(1e-12, 1.0)));
        const double turn = places.between(0.0, 2.0 * std::numbers::pi);
        const glm::dvec3 normal(-size * std::cos(turn), -size * std::sin(turn), 1.0);
        const double seen = std::max(glm::dot(normal, eye), 0.0);
        sum += seen * f64::schlick(seen / glm::length(normal), r0);
        weights += seen;
      }
      const f64::Water water =
          f64::open_water(up, eye, false, 1.0, f64::no_waves(), f64::frame_at(up), {2.0 * deviation * deviation, 0.0},
                          {0.0, 0.1, 0.0}, {0.0, 0.0}, 1e-3, plain_look());
      const double told = f64::varied_schlick(glm::dot(water.facing, eye), r0, water.variance);
      EXPECT_NEAR(told, sum / weights, 0.04) << deviation << ' ' << climb;
    }
  }
}

}  // namespace
}  // namespace terrella
