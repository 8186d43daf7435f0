// Sunlight that waves gather on the bottom.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

constexpr double index = 1.333;

f64::ShortWave wave_along(double angle, double wavenumber, double phase, double bend) {
  return {{std::cos(angle), std::sin(angle)}, wavenumber, phase, bend / (wavenumber * wavenumber), 0.0, 0.0, 0.0};
}

f64::Lens lens_of(const std::vector<f64::ShortWave>& waves, const glm::dvec2& arcs) {
  f64::Lens lens = f64::no_lens();
  for (const f64::ShortWave& wave : waves) f64::add_lens(lens, f64::course_of(wave, arcs), wave, 1.0);
  return lens;
}

// The lens tells how fast the surface's slopes change.
TEST(Caustics, BendAsTheSurfaceDoes) {
  Places places(3U);
  for (int i = 0; i < 100; ++i) {
    std::vector<f64::ShortWave> waves;
    for (int n = 0; n < 5; ++n)
      waves.push_back(wave_along(places.between(0.0, 6.28), places.between(1e6, 1e7), places.between(0.0, 6.28), 1.0));
    const glm::dvec2 at(places.between(-1e-5, 1e-5), places.between(-1e-5, 1e-5));
    const auto slope = [&](const glm::dvec2& arcs) {
      f64::WaveSum sum = f64::no_waves();
      for (const f64::ShortWave& wave : waves) f64::add_short_wave(sum, f64::course_of(wave, arcs), wave, 1.0);
      return sum.slope;
    };
    const double h = 1e-11;
    const glm::dvec2 east = (slope(at + glm::dvec2(h, 0.0)) - slope(at - glm::dvec2(h, 0.0))) / (2.0 * h);
    const glm::dvec2 north = (slope(at + glm::dvec2(0.0, h)) - slope(at - glm::dvec2(0.0, h))) / (2.0 * h);
    const f64::Lens lens = lens_of(waves, at);
    EXPECT_NEAR(lens.power.x, -east.x, 1e-4);
    EXPECT_NEAR(lens.power.y, -east.y, 1e-4);
    EXPECT_NEAR(lens.power.z, -north.y, 1e-4);
    EXPECT_DOUBLE_EQ(lens.spread, 2.5);
  }
}

TEST(Caustics, AreNoneWithoutWavesOrWay) {
  EXPECT_NEAR(f64::gathered_light(f64::no_lens(), 1.0, 0.1, index), 1.0, 1e-3);
  const f64::Lens crest = lens_of({wave_along(0.0, 1e6, 0.5 * std::numbers::pi, 1.0)}, {0.0, 0.0});
  EXPECT_NEAR(f64::gathered_light(crest, 1.0, 0.0, index), 1.0, 1e-3);
  EXPECT_NEAR(f64::gathered_light(crest, 0.0, 2.0, index), 1.0, 1e-3);
}

TEST(Caustics, AreBrightUnderCrestsAndDarkUnderTroughs) {
  const auto light = [&](double phase, double way) {
    return f64::gathered_light(lens_of({wave_along(0.3, 1e6, phase, 1.0)}, {0.0, 0.0}), 1.0, way, index);
  };
  const double crest = 0.5 * std::numbers::pi;
  EXPECT_GT(light(crest, 2.0), 1.4);
  EXPECT_LT(light(-crest, 2.0), 0.8);
  // A focus is the brightest.
  EXPECT_GT(light(crest, 4.0), light(crest, 1.0));
  EXPECT_GT(light(crest, 4.0), light(crest, 12.0));
}

// Waves spread as a wind's are, from above the focus to far below it.
TEST(Caustics, TakeNoLightAndGiveNone) {
  Places places(7U);
  std::vector<f64::ShortWave> waves;
  for (int n = 0; n < 40; ++n)
    waves.push_back(wave_along(places.between(-0.8, 0.8), places.between(1e6, 1e7), places.between(0.0, 6.28), 1.0));
  for (const double deviation : {0.1, 0.3, 0.6, 1.0, 2.0, 5.0, 20.0}) {
    const double way = deviation / (std::sqrt(20.0) * (1.0 - 1.0 / index));
    double sum = 0.0;
    constexpr int count = 20'000;
    for (int i = 0; i < count; ++i) {
      const glm::dvec2 at(places.between(-1.0, 1.0) * 1e-4, places.between(-1.0, 1.0) * 1e-4);
      sum += f64::gathered_light(lens_of(waves, at), 1.0, way, index) / count;
    }
    EXPECT_NEAR(sum, 1.0, 0.1) << deviation;
  }
}

}  // namespace
}  // namespace terrella
