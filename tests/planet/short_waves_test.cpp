#include "planet/short_waves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "laws/random_places.hpp"
#include "planet/wind_sea.hpp"
#include "scene/choices.hpp"

namespace terrella {
namespace {

constexpr double earth = 6.371e6, thirty_years = 9.467e8, felt = 1e-5;

Scene windy(double radius, double shortest) {
  Scene scene;
  scene.planet.radius = radius;
  scene.waves.count = 40;
  scene.waves.spectrum = choice("waves.spectrum", "wind");
  scene.waves.wind = 12.0;
  scene.waves.shortest = shortest;
  return scene;
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Waves of a place, each as strong as its region is there.
f64::WaveSum waves_at(const Sea& sea, const glm::dvec3& place, const f64::Frame& frame) {
  f64::WaveSum sum = f64::no_waves();
  const glm::dvec3 parts = f64::parts_of_regions(place);
  for (int axis = 0; axis < 3; ++axis) {
    if (parts[axis] <= 0.0) continue;
    for (const RegionalWave& wave : sea.short_waves)
      f64::add_wave(sum, place, frame, in_region(wave, region_around(axis, place)), parts[axis]);
  }
  return sum;
}

TEST(Regions, AreFarFromTheOriginsOfTheirWaves) {
  test::Places places(5U);
  const Sea sea = make_sea(windy(earth, 0.3), 0.0);
  ASSERT_EQ(sea.short_waves.size(), 40U);
  double nearest = 4.0;
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 place = places.on_sphere();
    const glm::dvec3 parts = f64::parts_of_regions(place);
    for (int axis = 0; axis < 3; ++axis) {
      if (parts[axis] <= 0.0) continue;
      const f64::Wave wave = in_region(sea.short_waves[static_cast<std::size_t>(i) % 40], region_around(axis, place));
      const double away = angle_between(place, wave.origin);
      nearest = std::min({nearest, away, std::numbers::pi - away});
    }
  }
  EXPECT_GT(nearest, 0.55);  // rad; measured: 0.59, at the corners of the regions
}

TEST(Regions, WavesRunWithTheWindInTheirMiddle) {
  Scene scene = windy(earth, 0.3);
  scene.waves.spread = 0.0;
  scene.waves.direction = 300.0;  // from the north-west by west
  const Sea sea = make_sea(scene, 0.0);
  for (int region = 0; region < regions; ++region) {
    glm::dvec3 middle(0.0);
    middle[region / 2] = region % 2 == 0 ? 1.0 : -1.0;
    const glm::dvec3 origin = in_region(sea.short_waves[0], region).origin;
    EXPECT_NEAR(glm::dot(origin, middle), 0.0, 1e-12);
    if (region >= 4) continue;  // where north is everywhere, or nowhere
    const glm::dvec3 north(0.0, 0.0, 1.0), east = glm::cross(north, middle);
    EXPECT_NEAR(glm::dot(origin, north), std::cos(300.0 * std::numbers::pi / 180.0), 1e-12);
    EXPECT_NEAR(glm::dot(origin, east), std::sin(300.0 * std::numbers::pi / 180.0), 1e-12);
  }
}

// What is short beside a planet runs in regions; what is long, around it.
TEST(Regions, HaveTheWavesThatAreShortBesideThePlanet) {
  EXPECT_TRUE(make_sea(windy(earth, 0.3), 0.0).waves.empty());
  const Sea small = make_sea(windy(2e4, 0.3), 0.0);
  EXPECT_FALSE(small.waves.empty());
  EXPECT_FALSE(small.short_waves.empty());
  EXPECT_EQ(small.waves.size() + small.short_waves.size(), 40U);
}

// The sum of an anchor's waves, in single precision as the GPU has it, against that of the waves themselves.
TEST(NearWaves, AreTheWavesThemselves) {
  test::Places places(9U);
  double worst = 0.0;
  for (const double radius : {1e5, earth, 1e8}) {
    const Sea sea = make_sea(windy(radius, 0.5), 1000.0);
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 eye = places.on_sphere() * 1.00001;
      const NearWaves near = near_waves(sea, eye, felt);
      const std::size_t n = static_cast<std::size_t>(i) % sea.short_waves.size();
      const RegionalWave& regional = sea.short_waves[n];
      // As far away as it is shown whole.
      const double reach = 40.0 * 2.0 * std::numbers::pi / regional.wavenumber;
      const double turn = places.between(0.0, 6.28), away = reach * places.between(0.0, 1.0);
      const glm::dvec3 aside = std::cos(turn) * near.axes.east + std::sin(turn) * near.axes.north;
      const glm::dvec3 place = std::cos(away) * near.anchor + std::sin(away) * aside;
      const glm::dvec3 offset = std::sin(away) * aside - 2.0 * std::pow(std::sin(0.5 * away), 2) * near.anchor;
      for (int axis = 0; axis < 3; ++axis) {
        const auto& waves = near.waves.at(static_cast<std::size_t>(axis));
        if (waves.empty() || f64::parts_of_regions(place)[axis] <= 0.0) continue;
        const f64::Wave exact = in_region(regional, region_around(axis, place));
        f64::WaveSum sum = f64::no_waves(), expected = f64::no_waves();
        const f64::Frame frame = f64::carried_axes(near.axes, near.anchor, place);
        f64::add_short_wave(sum, f64::course_of(waves[n], f64::arcs_from_anchor(offset, near.axes)), waves[n], 1.0);
        f64::add_wave(expected, place, frame, exact, 1.0);
        worst = std::max(worst, std::abs(sum.height - expected.height) / exact.amplitude);
        const double slope = glm::distance(sum.slope, expected.slope) / (exact.amplitude * exact.wavenumber);
        const double shift = glm::distance(sum.shift, expected.shift) / exact.pinch;
        worst = std::max({worst, slope, shift});
        EXPECT_NEAR(sum.stretch_ee, expected.stretch_ee, 0.02 * exact.pinch * exact.wavenumber);
        EXPECT_NEAR(sum.stretch_en, expected.stretch_en, 0.02 * exact.pinch * exact.wavenumber);
        EXPECT_NEAR(sum.stretch_nn, expected.stretch_nn, 0.02 * exact.pinch * exact.wavenumber);
      }
    }
  }
  EXPECT_LT(worst, 0.008);  // of the wave; measured: 0.0058, where waves are longest beside their planet
}

// Where a phase comes from after thirty years, in extended precision.
TEST(NearWaves, KnowTheirPhasesAfterThirtyYears) {
  const Scene scene = windy(earth, 0.5);
  const Sea start = make_sea(scene, 0.0), late = make_sea(scene, thirty_years);
  test::Places places(13U);
  long double worst = 0.0L;
  const long double turn = 2.0L * std::numbers::pi_v<long double>;
  for (int i = 0; i < 400; ++i) {
    const glm::dvec3 eye = places.on_sphere();
    const NearWaves near = near_waves(late, eye, felt);
    for (int axis = 0; axis < 3; ++axis) {
      const auto& waves = near.waves.at(static_cast<std::size_t>(axis));
      for (std::size_t n = 0; n < waves.size(); ++n) {
        const f64::Wave wave = in_region(start.short_waves[n], region_around(axis, eye));
        const glm::dvec3 &a = near.anchor, &o = wave.origin;
        const long double x = static_cast<long double>(a.y) * o.z - static_cast<long double>(a.z) * o.y;
        const long double y = static_cast<long double>(a.z) * o.x - static_cast<long double>(a.x) * o.z;
        const long double z = static_cast<long double>(a.x) * o.y - static_cast<long double>(a.y) * o.x;
        const long double cosine = static_cast<long double>(a.x) * o.x + static_cast<long double>(a.y) * o.y +
                                   static_cast<long double>(a.z) * o.z;
        const long double arc = std::atan2(std::sqrt(x * x + y * y + z * z), cosine);
        const long double frequency = deep_frequency(2.0 * std::numbers::pi * earth / wave.wavenumber);
        const long double phase = wave.phase + wave.wavenumber * arc - frequency * thirty_years;
        worst = std::max(worst, std::abs(std::remainder(phase - static_cast<long double>(waves[n].phase), turn)));
      }
    }
  }
  // Periods; bound: a hundredth for waves of half a metre.
  EXPECT_LT(static_cast<double>(worst / turn), 2e-5);
}

// The same place of the sea from eyes that lie apart: no wave jumps as its frame of reference moves, in single
// precision.
TEST(NearWaves, DoNotJumpWhenTheEyeMoves) {
  const Sea sea = make_sea(windy(earth, 0.5), thirty_years);
  test::Places places(17U);
  double worst = 0.0;
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 place = places.on_sphere();
    const glm::dvec3 side = f64::perpendicular(place);
    const std::size_t n = static_cast<std::size_t>(i) % sea.short_waves.size();
    const double length = 2.0 * std::numbers::pi / sea.short_waves[n].wavenumber;
    const auto height_from = [&](double away) {
      const NearWaves near = near_waves(sea, glm::normalize(place + away * side), felt);
      const f32::Frame axes = {glm::vec3(near.axes.east), glm::vec3(near.axes.north)};
      const f32::vec2 arcs = f32::arcs_from_anchor(glm::vec3(place - near.anchor), axes);
      const glm::dvec3 parts = f64::parts_of_regions(place);
      double height = 0.0;
      for (int axis = 0; axis < 3; ++axis) {
        const auto& waves = near.waves.at(static_cast<std::size_t>(axis));
        if (waves.empty() || parts[axis] <= 0.0) continue;
        const f64::ShortWave& w = waves[n];
        const f32::ShortWave wave = {glm::vec2(w.direction),
                                     static_cast<float>(w.wavenumber),
                                     static_cast<float>(w.phase),
                                     static_cast<float>(w.amplitude),
                                     static_cast<float>(w.pinch),
                                     static_cast<float>(w.bend),
                                     0.0F};
        f32::WaveSum sum = f32::no_waves();
        f32::add_short_wave(sum, f32::course_of(wave, arcs), wave, static_cast<float>(parts[axis]));
        height += sum.height;
      }
      return height / sea.short_waves[n].amplitude;
    };
    worst = std::max(worst, std::abs(height_from(20.0 * length) - height_from(-20.0 * length)));
  }
  EXPECT_LT(worst, 0.001);  // of the wave; measured: 2.6e-4
}

TEST(NearWaves, ReachOverTheBordersOfRegions) {
  const Sea sea = make_sea(windy(earth, 0.5), 0.0);
  const auto regions_at = [&](const glm::dvec3& eye) {
    int count = 0;
    for (const auto& waves : near_waves(sea, eye, felt).waves) count += waves.empty() ? 0 : 1;
    return count;
  };
  EXPECT_EQ(regions_at({1.0, 0.2, 0.1}), 1);
  EXPECT_EQ(regions_at({1.0, 0.99, 0.1}), 2);
  EXPECT_EQ(regions_at({-1.0, 0.97, -0.98}), 3);
}

// Water comes to lie over the anchor from aside; found by the surface itself.
TEST(NearWaves, TellTheWaterOverTheAnchor) {
  Scene scene = windy(earth, 2.0);
  scene.waves.steepness = 1.0;
  const Sea sea = make_sea(scene, 5.0);
  test::Places places(21U);
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 place = places.on_sphere();
    const NearWaves near = near_waves(sea, place, felt);
    const double height = waves_over(sea, near, {1.0, {0.0, 0.0}, 1.0, felt}).height;
    // The nearest of still places around, a tenth of a metre apart, to where the water of one of them lies over it.
    double nearest = 1.0, found = 0.0;
    for (int x = -60; x <= 60; ++x) {
      for (int y = -60; y <= 60; ++y) {
        const glm::dvec2 aside = glm::dvec2(x, y) * (0.1 / earth);
        const glm::dvec3 still = glm::normalize(place + aside.x * near.axes.east + aside.y * near.axes.north);
        const f64::WaveSum sum = waves_at(sea, still, f64::carried_axes(near.axes, near.anchor, still));
        const double missed = glm::length(aside + sum.shift);
        if (missed < nearest) {
          nearest = missed;
          found = sum.height;
        }
      }
    }
    EXPECT_LT(nearest * earth, 0.2);
    EXPECT_NEAR(height * earth, found * earth, 0.06);
  }
}

}  // namespace
}  // namespace terrella
