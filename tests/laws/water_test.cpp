#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/bare_scene.hpp"
#include "laws/equal.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::expect_equal;
using test::Places;

f64::WaterLook some_look() {
  f64::WaterLook look;
  look.color = {0.02, 0.1, 0.2};
  look.extinction = {30.0, 8.0, 3.0};
  look.foam_color = {0.9, 0.95, 1.0};
  look.foam = 0.8;
  look.clarity = 0.02;
  look.roughness = 0.3;
  look.refraction_index = 1.333;
  look.shininess = 60.0;
  look.glow = 0.0;
  look.crust = 0.0;
  look.shading = 0;
  return look;
}

const glm::dvec3 zenith(0.0, 0.0, 1.0);
const glm::dvec3 white(1.0), black(0.0);

// A direction so high over the horizon, to the side of +x or of -x.
glm::dvec3 risen(double sine, double side = 1.0) { return {side * std::sqrt(1.0 - sine * sine), 0.0, sine}; }

const glm::dvec2 turn(std::cos(0.7), std::sin(0.7));

TEST(Ripples, BeginWithNoneAndGrowFinerGentlerAndQuickerByLayers) {
  f64::Ripples r = f64::no_ripples(40.0, turn);
  EXPECT_EQ(r.gradient, glm::dvec3(0.0));
  EXPECT_EQ(r.rough + r.wash, 0.0);
  EXPECT_EQ(r.layer, 0);
  double steepness = 0.0, last = 1.0, angle = 0.7;
  for (int i = 0; i < 60; ++i) {
    EXPECT_EQ(r.layer, i);
    EXPECT_NEAR(r.frequency, 40.0 * std::pow(2.3, i), 1e-9 * r.frequency);
    if (i < 10) {
      EXPECT_LT(glm::distance(r.turn, glm::dvec2(std::cos(angle), std::sin(angle))), 1e-12);
    }
    EXPECT_LT(r.strength, last);
    steepness += r.strength;
    last = r.strength;
    angle *= 2.0;
    r = f64::next_layer(r);
  }
  EXPECT_NEAR(steepness, 0.11 / 0.3, 1e-6);  // all layers together, each 0.7 times as steep as the one before
}

TEST(Ripples, GradientIsThatOfTheWatersHeight) {
  Places places(361U);
  const double steepness = 0.8, h = 1e-7;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 d = places.on_sphere(), side = places.on_sphere();
    const f64::Ripples none = f64::no_ripples(40.0, turn);
    // The first layer's height: its noise (twice the wash) times its strength, a cell being 1/40.
    const auto height = [&](const glm::dvec3& place) {
      const double noise = 2.0 * f64::add_ripples(none, place, steepness, 0.0, 5U).wash;
      return noise * none.strength * steepness / none.frequency;
    };
    const glm::dvec3 gradient = f64::add_ripples(none, d, steepness, 0.0, 5U).gradient;
    ASSERT_NEAR(glm::dot(gradient, side), (height(d + h * side) - height(d - h * side)) / (2.0 * h), 1e-5);
  }
}

TEST(Ripples, WhatIsTooFineToBeSeenIsRoughness) {
  const glm::dvec3 d = risen(0.3);
  const f64::Ripples none = f64::no_ripples(40.0, turn);
  const f64::Ripples seen = f64::add_ripples(none, d, 0.8, 0.0, 5U), hidden = f64::add_ripples(none, d, 0.8, 1.0, 5U);
  EXPECT_EQ(seen.rough, 0.0);
  EXPECT_EQ(hidden.gradient, glm::dvec3(0.0));
  EXPECT_EQ(hidden.wash, 0.0);
  EXPECT_GT(hidden.rough, 0.0);
  EXPECT_EQ(hidden.rough, f64::roughened(none, 0.8, 0.0).rough);
  EXPECT_EQ(f64::roughened(none, 0.8, 1.0).rough, 0.0);
  EXPECT_NEAR(f64::roughened(none, 1.6, 0.0).rough, 4.0 * hidden.rough, 1e-15);
  // Shown to a half, a layer has a quarter of its square: the rest is roughness.
  EXPECT_NEAR(f64::roughened(none, 0.8, 0.5).rough, 0.75 * hidden.rough, 1e-15);
  EXPECT_NEAR(f64::roughened(f64::roughened(none, 0.8, 0.0), 0.8, 0.0).rough, 2.0 * hidden.rough, 1e-15);
  // Only so many layers are told.
  f64::Ripples r = none;
  for (int i = 0; i < f64::told_ripples; ++i) r = f64::add_ripples(r, d, 0.8, 1.0, 5U);
  EXPECT_EQ(f64::add_ripples(r, d, 0.8, 1.0, 5U).rough, r.rough);
  EXPECT_EQ(f64::add_ripples(r, d, 0.8, 0.0, 5U).wash, r.wash);
  EXPECT_NE(f64::add_ripples(r, d, 0.8, 0.0, 5U).gradient, r.gradient);
}

// A surface whose slopes have the mean square s2 is by Beckmann's measure one of a roughness whose fourth power is s2.
// The lobe of GGX, which has long tails, is told two thirds of it: measured 0.65.
TEST(Ripples, RoughnessIsThatOfTheSlopesThatItStandsFor) {
  Places places(362U);
  const f64::Ripples none = f64::no_ripples(40.0, turn);
  double squares = 0.0;
  const int count = 100'000;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 d = places.on_sphere();
    glm::dvec3 gradient = f64::add_ripples(none, d, 0.8, 0.0, 5U).gradient;
    gradient -= glm::dot(gradient, d) * d;
    squares += glm::dot(gradient, gradient) / count;
  }
  const double ratio = f64::roughened(none, 0.8, 0.0).rough / squares;
  RecordProperty("ratio", std::to_string(ratio));
  EXPECT_NEAR(ratio, 0.65, 0.05);
}

TEST(TornCrust, IsTornAsFarAsSamplesShow) {
  f64::WaterLook look = some_look();
  look.crust = 0.6;
  f64::Ripples r = f64::no_ripples(40.0, turn);
  for (const double wash : {-0.5, 0.0, 0.21, 0.9}) {
    r.wash = wash;
    EXPECT_NEAR(f64::torn_crust(r, 0.0, look), 0.6, 1e-12);
    EXPECT_NEAR(f64::torn_crust(r, 1.0, look), f64::crust_cover(wash, 0.6), 1e-12);
    EXPECT_NEAR(f64::torn_crust(r, 0.5, look), 0.5 * (0.6 + f64::crust_cover(wash, 0.6)), 1e-12);
  }
}

f64::Water calm(double depth, double wash, double crust = 0.0) {
  f64::Ripples r = f64::no_ripples(40.0, turn);
  r.wash = wash;
  return f64::calm_water(zenith, depth, r, crust, some_look());
}

TEST(CalmWater, WithoutRipplesIsSmoothAndLevel) {
  const f64::Water w = calm(0.01, 0.0);
  expect_equal(w.normal, zenith);
  EXPECT_EQ(w.depth, 0.01);
  EXPECT_NEAR(w.roughness, some_look().roughness, 1e-12);
}

TEST(CalmWater, LeansAgainstItsGradientAndGrowsRougherByWhatIsTold) {
  f64::Ripples r = f64::no_ripples(40.0, turn);
  r.gradient = {0.3, 0.0, 0.7};  // of which what points up is none
  r.rough = 0.5;
  const f64::Water w = f64::calm_water(zenith, 0.01, r, 0.0, some_look());
  expect_equal(w.normal, glm::normalize(glm::dvec3(-0.3, 0.0, 1.0)));
  EXPECT_NEAR(std::pow(w.roughness, 4.0), std::pow(some_look().roughness, 4.0) + 0.5, 1e-12);
  r.rough = 9.0;
  EXPECT_EQ(f64::calm_water(zenith, 0.01, r, 0.0, some_look()).roughness, 1.0);
}

TEST(CalmWater, FoamsAlongTheShoreAndUnderNoCrust) {
  const f64::WaterLook look = some_look();
  const double line = 0.3 * look.clarity;
  EXPECT_EQ(calm(0.0, 0.0).foam, look.foam);
  EXPECT_EQ(calm(0.2 * line, 0.0).foam, look.foam);
  EXPECT_NEAR(calm(0.6 * line, 0.0).foam, 0.5 * look.foam, 1e-12);
  EXPECT_EQ(calm(line, 0.0).foam, 0.0);
  EXPECT_EQ(calm(9.0 * line, 0.0).foam, 0.0);
  EXPECT_NEAR(calm(0.4 * line, 0.4).foam, calm(0.6 * line, 0.0).foam, 1e-12);   // run down
  EXPECT_NEAR(calm(0.8 * line, -0.4).foam, calm(0.6 * line, 0.0).foam, 1e-12);  // run up
  EXPECT_EQ(calm(9.0 * line, 0.0, 0.4).foam, 0.4);
  EXPECT_EQ(calm(0.0, 0.0, 0.4).foam, look.foam);
}

TEST(WavyWater, WithoutWavesIsLevelAndFoamsOnlyAtTheShore) {
  const f64::WaterLook look = some_look();
  const f64::Frame frame = f64::frame_at(zenith);
  const auto still = [&](double depth) {
    return f64::wavy_water(zenith, depth, f64::no_waves(), frame, 0.001, 0.02, look);
  };
  expect_equal(still(0.01).normal, zenith);
  EXPECT_EQ(still(0.01).depth, 0.01);
  EXPECT_EQ(still(0.01).roughness, look.roughness);
  EXPECT_NEAR(still(0.0).foam, 0.8 * look.foam, 1e-12);
  EXPECT_NEAR(still(0.2 * 0.02).foam, 0.4 * look.foam, 1e-12);
  EXPECT_EQ(still(0.35 * 0.02).foam, 0.0);
}

// A sum of waves whose surface has this normal in the frame's axes, up to its length.
f64::WaveSum sum_with(const glm::dvec2& slope, double height, double squeezed) {
  f64::WaveSum sum = f64::no_waves();
  sum.height = height;
  sum.slope = slope;
  sum.stretch_ee = sum.stretch_nn = squeezed - 1.0 - height;
  return sum;
}

TEST(WavyWater, NormalIsThatOfTheWavesHoweverTheFrameIsTurned) {
  Places places(363U);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 up = places.on_sphere();
    const f64::Frame frame = f64::frame_at(up);
    const glm::dvec2 slope(places.between(-0.4, 0.4), places.between(-0.4, 0.4));
    const f64::Water w = f64::wavy_water(up, 1.0, sum_with(slope, 0.0, 1.0), frame, 0.001, 0.02, some_look());
    ASSERT_LT(glm::distance(w.normal, glm::normalize(up - slope.x * frame.east - slope.y * frame.north)), 1e-12);
    const double angle = places.between(0.0, 6.28), c = std::cos(angle), s = std::sin(angle);
    const f64::Frame other{c * frame.east + s * frame.north, c * frame.north - s * frame.east};
    const glm::dvec2 there(c * slope.x + s * slope.y, c * slope.y - s * slope.x);
    const f64::Water same = f64::wavy_water(up, 1.0, sum_with(there, 0.0, 1.0), other, 0.001, 0.02, some_look());
    ASSERT_LT(glm::distance(w.normal, same.normal), 1e-12);
  }
}

TEST(WavyWater, FoamsOnHighCrestsWhoseWaterIsSqueezedTogether) {
  const f64::WaterLook look = some_look();
  const double amplitude = 0.001;
  const auto foam = [&](double rise, double jacobian) {
    const f64::WaveSum sum = sum_with({0.0, 0.0}, rise * amplitude, std::sqrt(jacobian));
    return f64::wavy_water(zenith, 1.0, sum, f64::frame_at(zenith), amplitude, 0.02, look).foam;
  };
  EXPECT_NEAR(foam(1.6, 0.25), look.foam, 1e-12);
  EXPECT_NEAR(foam(0.9, 0.25), 0.5 * look.foam, 1e-12);
  EXPECT_NEAR(foam(1.6, 0.5), 0.5 * look.foam, 1e-12);
  EXPECT_EQ(foam(1.6, 0.75), 0.0);
  EXPECT_EQ(foam(0.2, 0.25), 0.0);
  EXPECT_EQ(foam(-1.6, 0.25), 0.0);
  // Never more than is asked for, at a shore either; there a high wave is seen to foam further out.
  const auto at_shore = [&](double rise, double depth) {
    const f64::WaveSum sum = sum_with({0.0, 0.0}, rise * amplitude, 1.0);
    return f64::wavy_water(zenith, depth, sum, f64::frame_at(zenith), amplitude, 0.02, look).foam;
  };
  EXPECT_NEAR(at_shore(1.0, 0.25 * 0.02), 0.4 * look.foam, 1e-12);
  const f64::WaveSum both = sum_with({0.0, 0.0}, 1.6 * amplitude, 0.5);
  EXPECT_NEAR(f64::wavy_water(zenith, 0.0, both, f64::frame_at(zenith), amplitude, 0.02, look).foam, look.foam, 1e-12);
}

TEST(WavyWater, NormalNeverLeavesTheUpperSideWhereTheSurfaceHasFolded) {
  f64::WaveSum folded = sum_with({0.3, 0.1}, 0.0, 0.4);
  folded.stretch_ee = -1.5;
  EXPECT_LT(f64::wave_normal(folded).z, 0.0);
  EXPECT_GT(f64::wavy_water(zenith, 1.0, folded, f64::frame_at(zenith), 0.001, 0.02, some_look()).normal.z, 0.0);
}

TEST(RefractedRay, FollowsSnellIntoTheWater) {
  Places places(364U);
  f64::WaterLook look = some_look();
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 normal = places.on_sphere();
    glm::dvec3 ray = places.on_sphere();
    if (glm::dot(ray, normal) > 0.0) ray = -ray;
    look.refraction_index = places.between(1.0, 2.0);
    const glm::dvec3 inside = f64::refracted_ray(ray, normal, look);
    ASSERT_NEAR(glm::length(inside), 1.0, 1e-12);
    ASSERT_LT(glm::dot(inside, normal), 0.0);
    ASSERT_LT(glm::distance(look.refraction_index * glm::cross(inside, normal), glm::cross(ray, normal)), 1e-12);
  }
}

TEST(DiveOf, IsTheCosineHeldToAQuarter) {
  EXPECT_NEAR(f64::dive_of(-zenith, zenith), 1.0, 1e-12);
  EXPECT_NEAR(f64::dive_of(-risen(0.6), zenith), 0.6, 1e-12);
  EXPECT_EQ(f64::dive_of(-risen(0.1), zenith), 0.25);
  EXPECT_EQ(f64::dive_of(risen(0.5), zenith), 0.25);
}

const glm::dvec3 sand(0.6, 0.5, 0.3);

TEST(LightThrough, WithoutWaterIsThatOfTheGround) {
  const f64::SceneLight scene = test::bare_scene(risen(0.8));
  const f64::LightAt at = f64::light_at(zenith, 0.0, scene);
  for (const double shade : {0.0, 0.4, 1.0}) {
    expect_equal(f64::light_through(sand, zenith, 0.0, 0.0, at, shade, some_look(), scene),
                 f64::ground_light(sand, zenith, at, shade, scene));
  }
}

TEST(LightThrough, DimsTheBottomByBothWaysThroughTheWater) {
  const f64::SceneLight scene = test::bare_scene(risen(0.5));
  const f64::LightAt at = f64::light_at(zenith, 0.0, scene);
  const f64::WaterLook look = some_look();
  const auto of_bottom = [&](double depth, double way) {  // what a black bottom lacks
    return f64::light_through(sand, zenith, depth, way, at, 0.7, look, scene) -
           f64::light_through(glm::dvec3(0.0), zenith, depth, way, at, 0.7, look, scene);
  };
  const glm::dvec3 dry = f64::ground_light(sand, zenith, at, 0.7, scene);
  expect_equal(of_bottom(0.0, 0.05), dry * glm::exp(-0.05 * look.extinction));
  expect_equal(of_bottom(0.02, 0.0), dry * glm::exp(-0.04 * look.extinction));  // down at 30 degrees: twice the depth
  expect_equal(of_bottom(0.02, 0.03), dry * glm::exp(-0.07 * look.extinction));
  expect_equal(of_bottom(1e3, 1e3), glm::dvec3(0.0));
}

TEST(LightThrough, OfDeepWaterIsItsOwnColorByTheLightThatFallsIn) {
  const f64::WaterLook look = some_look();
  f64::SceneLight scene = test::bare_scene(risen(0.5));
  f64::LightAt at = f64::light_at(zenith, 0.0, scene);
  const auto deep = [&](double shade) { return f64::light_through(sand, zenith, 9.0, 9.0, at, shade, look, scene); };
  expect_equal(deep(1.0), 0.6 * look.color * at.sun * (0.65 / 1.15));
  expect_equal(deep(0.3), 0.3 * deep(1.0));
  scene.ambient = 0.2;
  at = f64::light_at(zenith, 0.0, scene);
  expect_equal(deep(0.0), 0.6 * look.color * f64::skylight(at, zenith, scene));
  // What a way through water does not let through of the bottom, the water itself sends.
  const glm::dvec3 half = f64::light_through(
      glm::dvec3(0.0), zenith, 0.0, std::log(2.0), at, 1.0,
      [&] {
        f64::WaterLook one = look;
        one.extinction = glm::dvec3(1.0);
        return one;
      }(),
      scene);
  expect_equal(half, 0.5 * deep(1.0));
}

f64::Water level(double foam = 0.0, double depth = 0.01) {
  f64::Water w;
  w.normal = w.facing = zenith;
  w.variance = 0.0;
  w.depth = depth;
  w.foam = foam;
  w.roughness = 0.3;
  return w;
}

// Where no sky lights the bottom.
TEST(LightThrough, IsSunlightAndSkylight) {
  const f64::SceneLight scene = test::bare_scene(risen(0.5));
  const f64::LightAt at = f64::light_at(zenith, 0.0, scene);
  const f64::WaterLook look = some_look();
  const glm::dvec3 of_bottom = f64::light_through(sand, zenith, 0.02, 0.03, at, 0.7, look, scene) -
                               f64::light_through(glm::dvec3(0.0), zenith, 0.02, 0.03, at, 0.7, look, scene);
  expect_equal(f64::sunlight_through(sand, zenith, 0.02, 0.03, at, 0.7, look, scene), of_bottom);
}

// Light of a place of water at a depth goes on to the eye, and is gathered along the way: summed up in small steps.
TEST(ThroughWater, GathersWhatTheWaterAddsAlongTheWay) {
  const f64::WaterLook look = some_look();
  for (const double sun : {0.2, 0.5, 1.0}) {
    const f64::SceneLight scene = test::bare_scene(risen(sun));
    const f64::LightAt at = f64::light_at(zenith, 0.0, scene);
    const double steep = std::max(sun, 0.3);
    const glm::dvec3 source = f64::light_of_depths(at, 0.7, look, scene) * (1.0 + 1.0 / steep);
    for (const double climb : {-1.0, -0.3, 0.0, 0.2999999, 0.3, 0.5, 1.0}) {
      const double depth = 0.1, way = climb > 0.0 ? depth / climb : 0.4;
      glm::dvec3 sum(0.0);
      constexpr int steps = 20'000;
      for (int i = 0; i < steps; ++i) {
        const double along = (i + 0.5) / steps * way;
        const double there = depth - climb * along;
        sum += source * look.extinction * f64::transmitted(look.extinction, along) *
               f64::transmitted(look.extinction, there / steep) * (way / steps);
      }
      const glm::dvec3 light(0.3, 0.4, 0.5);
      sum += light * f64::transmitted(look.extinction, way);
      const glm::dvec3 found = f64::through_water(light, depth, climb, way, at, 0.7, look, scene);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], sum[c], 2e-5 * (1.0 + sum[c])) << sun << ' ' << climb;
    }
  }
}

TEST(ThroughWater, IsDeepWaterSeenFromItsSurfaceStraightDown) {
  const f64::SceneLight scene = test::bare_scene(risen(0.8));
  const f64::LightAt at = f64::light_at(zenith, 0.0, scene);
  expect_equal(f64::through_water(white, 0.0, -1.0, 100.0, at, 0.7, some_look(), scene),
               f64::light_of_depths(at, 0.7, some_look(), scene));
}

// Snell's law and Fresnel's, beyond whose angle all light is thrown back.
TEST(SurfaceFromBelow, RefractsAndMirrorsAsItShould) {
  const f64::WaterLook look = some_look();
  const glm::dvec3 down = -zenith;
  const double n = look.refraction_index;
  for (double sine = 0.0; sine < 1.0; sine += 0.01) {
    const glm::dvec3 ray(sine, 0.0, std::sqrt(1.0 - sine * sine));
    const glm::dvec3 above = f64::ray_above(ray, down, look);
    const double mirrored = f64::mirrored_from_below(0.0, down, ray, look);
    EXPECT_NEAR(glm::length(above), 1.0, 1e-9);
    if (n * sine >= 1.0) {
      EXPECT_NEAR(above.z, 0.0, 1e-9);
      if (n * sine > 1.01) {
        EXPECT_EQ(mirrored, 1.0) << sine;
      }
      continue;
    }
    EXPECT_NEAR(above.x, n * sine, 1e-9);
    const double in = ray.z, out = above.z;
    const double s = (n * in - out) / (n * in + out), p = (n * out - in) / (n * out + in);
    if (n * sine < 0.99) {
      EXPECT_NEAR(mirrored, 0.5 * (s * s + p * p), 0.055) << sine;  // measured, at the edge: 0.052
    }
  }
}

// Waves that are not shown blur the edge of the window.
TEST(SurfaceFromBelow, MirrorsPartOfTheLightAroundTheAngleOfTotalReflection) {
  const f64::WaterLook look = some_look();
  const double edge = 1.0 / look.refraction_index;
  const auto mirrored = [&](double sine, double variance) {
    return f64::mirrored_from_below(variance, -zenith, {sine, 0.0, std::sqrt(1.0 - sine * sine)}, look);
  };
  EXPECT_LT(mirrored(edge - 0.05, 0.0), 0.3);
  EXPECT_GT(mirrored(edge - 0.05, 0.01), 0.35);
  EXPECT_EQ(mirrored(edge + 0.05, 0.0), 1.0);
  EXPECT_GT(mirrored(edge + 0.05, 0.01), 0.6);
}

// The sun's light that comes through a rough surface is spread over directions, none lost and none gained but by what
// no facet faces.
TEST(GlitterThrough, SpreadsTheLightThatComesIn) {
  test::Places places(77U);
  for (const double roughness : {0.2, 0.4}) {
    for (const double sine : {0.4, 0.95}) {
      const glm::dvec3 sun = risen(sine);
      double sum = 0.0;
      constexpr int count = 400'000;
      for (int i = 0; i < count; ++i) {
        glm::dvec3 to_eye = places.on_sphere();
        to_eye.z = -std::fabs(to_eye.z);
        sum += f64::glitter_through(zenith, sun, to_eye, 1.333, roughness) * -to_eye.z * 2.0 * std::numbers::pi / count;
      }
      // In directions in the water: as many as its beams are narrowed fewer.
      EXPECT_NEAR(sum * 1.333 * 1.333 / sine, 1.0, 0.15) << roughness << ' ' << sine;
    }
  }
}

TEST(WaterLight, MirrorsByFresnelAndLetsThroughTheRest) {
  const f64::SceneLight scene = test::bare_scene(risen(0.5));
  const f64::LightAt at = f64::light_at(zenith, 0.0, scene);
  const f64::WaterLook look = some_look();
  const double r0 = std::pow(0.333 / 2.333, 2.0);
  double before = 1.0;
  for (double sine = 0.0; sine <= 1.0; sine += 0.05) {
    const glm::dvec3 ray = -risen(sine);
    const glm::dvec3 mirrored = f64::water_light(level(), at, ray, black, white, 0.0, look, scene);
    const glm::dvec3 through = f64::water_light(level(), at, ray, white, black, 0.0, look, scene);
    expect_equal(mirrored + through, white);  // nothing is lost and nothing gained
    EXPECT_LE(mirrored.r, before + 1e-12);
    before = mirrored.r;
  }
  EXPECT_NEAR(f64::water_light(level(), at, -zenith, black, white, 0.0, look, scene).r, r0, 1e-12);
  EXPECT_NEAR(f64::water_light(level(), at, -risen(0.0), black, white, 0.0, look, scene).r, 1.0, 1e-12);
}

// The sun's glitter alone, as a part of the sunlight.
double sun_glitter(const glm::dvec3& sun, const glm::dvec3& to_eye, double roughness, double shade = 1.0) {
  const f64::SceneLight scene = test::bare_scene(sun);
  const f64::LightAt at{zenith, scene.sunlight, black};
  f64::Water w = level();
  w.roughness = roughness;
  return f64::water_light(w, at, -to_eye, black, black, shade, some_look(), scene).r / scene.sunlight.r;
}

TEST(WaterLight, GlittersTheSameWithSunAndEyeExchanged) {
  Places places(365U);
  for (int i = 0; i < 1000; ++i) {
    glm::dvec3 sun = places.on_sphere(), eye = places.on_sphere();
    sun.z = std::fabs(sun.z) + 0.01;
    eye.z = std::fabs(eye.z) + 0.01;
    sun = glm::normalize(sun);
    eye = glm::normalize(eye);
    // By cosines, as light falls on a surface at a slant.
    const double there = sun_glitter(sun, eye, 0.5) / sun.z, back = sun_glitter(eye, sun, 0.5) / eye.z;
    ASSERT_NEAR(there, back, 1e-9 * (there + back) + 1e-12);
  }
}

TEST(WaterLight, IsNotSeenWhereThereIsLand) {
  const f64::SceneLight scene = test::bare_scene(risen(0.7, -1.0));
  const f64::LightAt at = f64::light_at(zenith, 0.0, scene);
  for (const int shading : {0, 1}) {
    f64::WaterLook look = some_look();
    look.shading = shading;
    look.glow = 3.0;
    for (const double depth : {0.0, -0.1}) {
      expect_equal(f64::water_light(level(1.0, depth), at, -risen(0.7), sand, white, 1.0, look, scene), sand);
    }
  }
}

TEST(WaterLight, GlittersMostWhereItMirrorsTheSunAndNotThroughClouds) {
  const glm::dvec3 sun = risen(0.7, -1.0);
  const double mirror = sun_glitter(sun, risen(0.7), 0.2);
  EXPECT_GT(mirror, 2.0 * sun_glitter(sun, risen(0.95), 0.2));
  EXPECT_GT(mirror, 10.0 * sun_glitter(sun, sun, 0.2));
  EXPECT_NEAR(sun_glitter(sun, risen(0.7), 0.2, 0.25), 0.25 * mirror, 1e-12);
  EXPECT_EQ(sun_glitter(sun, risen(0.7), 0.2, 0.0), 0.0);
  EXPECT_EQ(sun_glitter(risen(-0.2, -1.0), risen(0.2), 0.2), 0.0);
  EXPECT_LE(sun_glitter(sun, risen(0.7), 0.02), 40.0);
  // Lobe and Fresnel's factor, both at the angle of the mirror.
  const double r = f64::schlick(0.7, f64::reflectance_at_normal(1.0, 1.333));
  EXPECT_NEAR(mirror, r * f64::glitter(1.0, 0.7, 0.7, 0.2), 1e-9);
}

TEST(WaterLight, SendsBackNoMoreSunlightThanFresnelAllows) {
  Places places(366U);
  for (const double height : {0.3, 0.9}) {
    const glm::dvec3 sun = risen(height);
    double sum = 0.0;
    const int count = 200'000;
    for (int i = 0; i < count; ++i) {
      glm::dvec3 eye = places.on_sphere();
      eye.z = std::fabs(eye.z);
      sum += sun_glitter(sun, eye, 0.4) * eye.z * 2.0 * std::numbers::pi / count;
    }
    // Of what falls on a level surface; at a slant the lobe leans to where more is mirrored.
    const double mirrored = f64::schlick(height, f64::reflectance_at_normal(1.0, 1.333));
    EXPECT_LT(sum / height, 1.5 * mirrored) << height;
    EXPECT_GT(sum / height, 0.4 * mirrored) << height;
  }
}

TEST(WaterLight, ByPhongAddsAHighlightWhereItMirrorsTheSun) {
  f64::WaterLook look = some_look();
  look.shading = 1;
  const f64::SceneLight scene = test::bare_scene(risen(0.7, -1.0));
  const f64::LightAt at{zenith, scene.sunlight, black};
  const auto light = [&](const glm::dvec3& to_eye, double shade) {
    return f64::water_light(level(), at, -to_eye, sand, white, shade, look, scene) - sand;
  };
  expect_equal(light(risen(0.7), 1.0), 0.08 * f64::phong(1.0, look.shininess) * scene.sunlight);
  expect_equal(light(risen(0.7), 0.5), 0.5 * light(risen(0.7), 1.0));
  EXPECT_LT(light(risen(0.9), 1.0).r, 0.5 * light(risen(0.7), 1.0).r);
  expect_equal(light(scene.sun, 1.0), black, 1e-6);
}

TEST(WaterLight, IsHiddenByFoamAsFarAsItCovers) {
  f64::SceneLight scene = test::bare_scene(zenith);
  const f64::WaterLook look = some_look();
  f64::LightAt at = f64::light_at(zenith, 0.0, scene);
  const auto light = [&](double foam, double shade) {
    return f64::water_light(level(foam), at, -risen(0.6), sand, white, shade, look, scene);
  };
  expect_equal(light(1.0, 1.0), 0.55 * look.foam_color * at.sun);
  expect_equal(light(1.0, 0.5), 0.5 * light(1.0, 1.0));
  expect_equal(light(0.3, 1.0), 0.7 * light(0.0, 1.0) + 0.3 * light(1.0, 1.0));
  scene.ambient = 0.3;
  at = f64::light_at(zenith, 0.0, scene);
  expect_equal(light(1.0, 0.0), 0.55 * look.foam_color * f64::skylight(at, zenith, scene));
  // The sun at a slant: wrapped a little.
  scene = test::bare_scene(risen(0.45));
  at = {zenith, scene.sunlight, black};
  expect_equal(light(1.0, 1.0), 0.55 * (0.55 / 1.1) * look.foam_color * scene.sunlight);
}

TEST(WaterLight, GlowsByItselfThroughNoFoamAndNoCrust) {
  const f64::SceneLight scene = test::bare_scene(-zenith);
  const f64::LightAt at = f64::light_at(zenith, 0.0, scene);
  f64::WaterLook look = some_look();
  look.glow = 2.0;
  const auto glow = [&](double foam) {
    return f64::water_light(level(foam), at, -zenith, black, black, 1.0, look, scene);
  };
  expect_equal(glow(0.0), 2.0 * look.color);
  expect_equal(glow(1.0), 0.1 * look.color);
  look.glow = 0.0;
  expect_equal(glow(0.0), black);  // a dark night
}

TEST(WaterLight, IsTheSameHoweverTheSceneIsTurned) {
  Places places(367U);
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 x = places.on_sphere(), y = glm::normalize(glm::cross(x, places.on_sphere()));
    const glm::dmat3 turned(x, y, glm::cross(x, y));
    const glm::dvec3 sun = places.on_sphere(), ray = -risen(places.between(0.05, 1.0));
    f64::WaterLook look = some_look();
    look.shading = i % 2;
    const auto light = [&](const glm::dmat3& t) {
      f64::SceneLight scene = test::bare_scene(t * sun);
      scene.ambient = 0.2;
      f64::Water w = level(0.2);
      w.normal = w.facing = t * zenith;
      return f64::water_light(w, f64::light_at(t * zenith, 0.0, scene), t * ray, sand, white, 0.8, look, scene);
    };
    ASSERT_LT(glm::distance(light(glm::dmat3(1.0)), light(turned)), 1e-9);
  }
}

}  // namespace
}  // namespace terrella
