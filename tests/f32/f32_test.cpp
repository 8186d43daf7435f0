// Single precision against double, for what the functions that the probe holds (tests/probe) are made of, and over the
// domain of a planet. u is half a unit in the last place of single precision; bounds are those that each formula's form
// allows.
#include <gtest/gtest.h>

#include <numbers>

#include "formulas/formulas.hpp"
#include "height_maps.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

constexpr double u = 5.9604644775390625e-8;
constexpr int tries = 100'000;

// The same numbers in both precisions: a float and its exact double.
float rounded(double x) { return static_cast<float>(x); }
double exact(float x) { return double{x}; }

TEST(SinglePrecision, SimplexAndFlowNoise) {
  Places places(1U);
  for (int i = 0; i < tries; ++i) {
    const glm::vec3 q(places.in_cube(100.0));
    const f32::Noise a = f32::simplex_noise(glm::ivec3(0), q, 7U);
    const f64::Noise b = f64::simplex_noise(glm::ivec3(0), glm::dvec3(q), 7U);
    ASSERT_NEAR(a.value, b.value, 5e-4);
    ASSERT_LT(glm::distance(glm::dvec3(a.gradient), b.gradient), 2e-3);
    const float angle = rounded(places.between(-3.2, 3.2));
    ASSERT_NEAR(f32::flow_noise(glm::ivec3(0), q, angle, 7U).value,
                f64::flow_noise(glm::ivec3(0), glm::dvec3(q), exact(angle), 7U).value, 5e-4);
  }
}

TEST(SinglePrecision, NoiseToldFromANearCellKeepsItsPrecisionAtAnyFrequency) {
  Places places(2U);
  for (int i = 0; i < tries / 10; ++i) {
    const glm::ivec3 cell(places.in_cube(1e7));
    const glm::vec3 q(places.in_cube(50.0));
    ASSERT_NEAR(f32::simplex_noise(cell, q, 7U).value, f64::simplex_noise(cell, glm::dvec3(q), 7U).value, 5e-4);
  }
}

// In double precision these are the library's, so this holds the polynomials to the true functions.
TEST(SinglePrecision, CosineAndSineOfAnAngle) {
  Places places(20U);
  for (int i = 0; i < tries; ++i) {
    const float angle = rounded(places.between(-1.0, 1.0) * std::pow(10.0, places.between(-6.0, 4.0)));
    const glm::dvec2 expected = f64::cos_sin(exact(angle));
    // Reducing the angle to a turn rounds it three times; beyond that, 3.5e-7 is the most of five million.
    ASSERT_LT(glm::distance(glm::dvec2(f32::cos_sin(angle)), expected), 4e-7 + 3.0 * u * std::fabs(exact(angle)))
        << angle;
  }
}

TEST(SinglePrecision, ArcOfASineAndACosine) {
  Places places(21U);
  for (int i = 0; i < tries; ++i) {
    const double angle = std::numbers::pi * std::pow(10.0, places.between(-6.0, 0.0));
    const float sine = rounded(std::sin(angle)), cosine = rounded(std::cos(angle));
    // The most of five million: 3.0e-7.
    ASSERT_NEAR(f32::arc(sine, cosine), f64::arc(exact(sine), exact(cosine)), 4e-7 * angle) << angle;
  }
  EXPECT_EQ(f32::arc(0.0F, 1.0F), 0.0F);
  EXPECT_NEAR(f32::arc(0.0F, -1.0F), std::numbers::pi, 4e-7);
  EXPECT_NEAR(f32::arc(1.0F, 0.0F), 0.5 * std::numbers::pi, 4e-7);
}

TEST(SinglePrecision, AirPathFromNearAndFar) {
  Places places(7U);
  for (int i = 0; i < tries; ++i) {
    const double away = std::pow(10.0, places.between(0.0, 3.0));
    const glm::vec3 eye(places.on_sphere() * away);
    const glm::vec3 ray = glm::normalize(glm::vec3(places.on_sphere() * 1.1 - glm::dvec3(eye) / away));
    const f32::AirPath a = f32::air_path(eye, ray, 1.14F);
    const f64::AirPath b = f64::air_path(glm::dvec3(eye), glm::dvec3(ray), exact(1.14F));
    // The ray's distance from the centre is known to a few u of the eye's distance; a grazing chord multiplies that.
    const double error = 16.0 * u * away;
    const double bound = error * (2.0 + 1.2 / std::fmax(b.cosine, std::sqrt(error)));
    ASSERT_NEAR(a.enter, b.enter, bound) << away;
    ASSERT_NEAR(a.leave, b.leave, bound) << away;
  }
}

TEST(SinglePrecision, TerrainHeight) {
  Places places(8U);
  f32::Terrain t;
  t.height = 0.15F;
  t.frequency = 1.3F;
  t.octaves = 10;
  t.persistence = 0.5F;
  t.lacunarity = 2.03F;
  t.power = 2.1F;
  t.ridged = false;
  t.sharpness = 14.0F;
  t.seed = 3U;
  t.craters.depth = 1.0F;
  t.craters.frequency = 2.0F;
  t.craters.sizes = 6;
  t.craters.seed = 3U;
  t.ice = {0.0F, 2.0F, 0.0012F, 3U};
  f64::Terrain d;
  d.height = exact(t.height);
  d.frequency = exact(t.frequency);
  d.octaves = t.octaves;
  d.persistence = exact(t.persistence);
  d.lacunarity = exact(t.lacunarity);
  d.power = exact(t.power);
  d.ridged = t.ridged;
  d.sharpness = exact(t.sharpness);
  d.seed = t.seed;
  d.craters.depth = 1.0;
  d.craters.frequency = 2.0;
  d.craters.sizes = 6;
  d.craters.seed = 3U;
  d.ice = {0.0, 2.0, double{0.0012F}, 3U};
  for (const float ranges : {0.0F, 0.3F}) {
    t.ranges = {ranges, 1, 0.1F};
    d.ranges = {exact(ranges), 1, exact(0.1F)};
    double worst = 0.0, worst_gradient = 0.0;
    for (int i = 0; i < tries / 4; ++i) {
      const glm::vec3 direction(places.on_sphere());
      const f32::Height a = f32::terrain_height_at(direction, t, 1e-4F);
      const f64::Height b = f64::terrain_height_at(glm::dvec3(direction), d, exact(1e-4F));
      worst = std::fmax(worst, std::fabs(exact(a.value) - b.value));
      worst_gradient = std::fmax(worst_gradient, glm::distance(glm::dvec3(a.gradient), b.gradient));
    }
    EXPECT_LT(worst, ranges > 0.0F ? 5e-7 : 2e-7)
        << ranges;  // measured: 8.5e-8 planet radii without, 1.8e-7 with ranges
    // Measured: 1.9e-4, of slopes up to 2; with ranges, whose crests bend sharply, 2.4e-3.
    EXPECT_LT(worst_gradient, ranges > 0.0F ? 4e-3 : 4e-4) << ranges;
  }
}

// As far away as waves are shown: a phase is known to some u of the turns up to there.
TEST(SinglePrecision, ShortWaves) {
  Places places(37U);
  for (int i = 0; i < tries; ++i) {
    const double turn = places.between(0.0, 6.28);
    f32::ShortWave a{};
    a.direction = glm::vec2(std::cos(turn), std::sin(turn));
    a.wavenumber = rounded(std::pow(10.0, places.between(3.7, 9.5)));
    a.phase = rounded(places.between(-3.1, 3.1));
    a.amplitude = 0.05F / a.wavenumber;
    a.pinch = 0.8F * a.amplitude;
    a.bend = rounded(places.between(-1.7, 1.7));
    const double reach = 600.0 / exact(a.wavenumber);
    const glm::vec2 arcs(places.between(-reach, reach), places.between(-reach, reach));
    const f64::ShortWave b = {glm::dvec2(a.direction),
                              exact(a.wavenumber),
                              exact(a.phase),
                              exact(a.amplitude),
                              exact(a.pinch),
                              exact(a.bend),
                              0.0};
    f32::WaveSum sum = f32::no_waves();
    f64::WaveSum expected = f64::no_waves();
    f32::add_short_wave(sum, f32::course_of(a, arcs), a, 1.0F);
    f64::add_short_wave(expected, f64::course_of(b, glm::dvec2(arcs)), b, 1.0);
    const double off = 1e-6 + 16.0 * u * b.wavenumber * glm::length(glm::dvec2(arcs));
    ASSERT_NEAR(sum.height, expected.height, off * b.amplitude) << i;
    ASSERT_LT(glm::distance(glm::dvec2(sum.shift), expected.shift), off * b.pinch) << i;
    ASSERT_LT(glm::distance(glm::dvec2(sum.slope), expected.slope), off * b.amplitude * b.wavenumber) << i;
    ASSERT_NEAR(sum.stretch_en, expected.stretch_en, off * b.pinch * b.wavenumber) << i;
  }
}

TEST(SinglePrecision, Shoaling) {
  Places places(41U);
  for (int i = 0; i < tries; ++i) {
    const float depth = rounded(std::pow(10.0, places.between(-4.0, 1.0)));
    ASSERT_NEAR(f32::gained_phase(depth), f64::gained_phase(exact(depth)), 8.0 * u) << depth;
    ASSERT_NEAR(f32::shortened(depth), f64::shortened(exact(depth)), 8.0 * u * 4.0) << depth;
  }
}

TEST(SinglePrecision, MapOfHeights) {
  for (const SharedHeightMap& map : {test::smooth_map(512, 256), test::rough_map(512, 256, 1)}) {
    const HeightTexels texels = {map.get(), map->serial()};
    Places places(31U);
    for (int i = 0; i < tries; ++i) {
      const glm::vec3 d = glm::normalize(glm::vec3(places.on_sphere()));
      const float footprint = rounded(std::pow(10.0, places.between(-3.0, 0.5)));
      const f32::MapHeight a = f32::map_height_at(texels, d, footprint);
      const f64::MapHeight b = f64::map_height_at(texels, glm::normalize(glm::dvec3(d)), exact(footprint));
      // A place is known to some u of the map's sides: heights differ by as much as they rise there.
      const double place = 16.0 * u * map->steepest();
      ASSERT_NEAR(a.value, b.value, 4.0 * u + place);
      ASSERT_LT(glm::distance(glm::dvec3(a.gradient), b.gradient), 2.0 * place * 512.0) << i;
    }
  }
}

}  // namespace
}  // namespace terrella
