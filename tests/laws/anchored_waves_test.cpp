// Waves told from an anchor against the waves as they are defined: positions by sine and cosine of whole arcs, normals
// by differences.
#include <gtest/gtest.h>

#include <vector>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"
#include "probe/evaluate.hpp"
#include "probe/function.hpp"

namespace terrella {
namespace {

using probe::Json;
using test::Places;

struct Sea {
  double r;
  double t;
  bool fades;
  double from, to;
  struct Wave {
    glm::dvec3 o;
    double amplitude, w, phi, pinch;
  };
  std::vector<Wave> waves;
};

Sea some_sea(Places& places, int count, bool fades) {
  Sea sea{50.0, places.between(-10.0, 10.0), fades, 0.05, 0.6, {}};
  for (int i = 0; i < count; ++i) {
    const double w = places.between(1.0, 4.0);
    sea.waves.push_back({places.between(0.5, 2.0) * places.on_sphere(), 0.6 / (w * count), w, places.between(-3.0, 3.0),
                         places.between(0.2, 1.0)});
  }
  return sea;
}

// P of a direction, as it is defined.
glm::dvec3 surface(const Sea& sea, const glm::dvec3& v) {
  glm::dvec3 p = sea.r * v;
  for (const Sea::Wave& wave : sea.waves) {
    const glm::dvec3 o = glm::normalize(wave.o);
    const double cosine = glm::dot(v, o), sine = glm::length(glm::cross(v, o));
    const double psi = wave.w * sea.r * std::atan2(sine, cosine) + wave.phi * sea.t;
    double fade = 1.0;
    if (sea.fades) {
      const double x = std::fmin(std::fmax((1.0 - std::fabs(cosine) - sea.from) / (sea.to - sea.from), 0.0), 1.0);
      fade = x * x * (3.0 - 2.0 * x);
    }
    p += wave.amplitude * std::sin(psi) * v;
    p += fade * wave.pinch * wave.amplitude * std::cos(psi) / sine * (v * cosine - o);
  }
  return p;
}

Json arguments(const Sea& sea, const glm::dvec3& anchor, const glm::dvec3& q) {
  Json waves = Json::array();
  for (const Sea::Wave& w : sea.waves) {
    waves.push_back({{"o", {w.o.x, w.o.y, w.o.z}}, {"A", w.amplitude}, {"w", w.w}, {"phi", w.phi}, {"Q", w.pinch}});
  }
  Json args = {
      {"q", {q.x, q.y, q.z}}, {"anchor", {anchor.x, anchor.y, anchor.z}}, {"r", sea.r}, {"t", sea.t}, {"waves", waves}};
  if (sea.fades) args["fade"] = {sea.from, sea.to};
  return args;
}

probe::Answers<double> anchored(const Sea& sea, const glm::dvec3& anchor, const glm::dvec3& q) {
  const auto numbers = probe::find_function("gerstner")->prepare(arguments(sea, anchor, q));
  EXPECT_TRUE(numbers) << numbers.sentence();
  return probe::evaluate_f64("gerstner", *numbers);
}

TEST(AnchoredWaves, AreTheWavesAsDefinedWithTheirExactNormal) {
  Places places(281U);
  for (const bool fades : {false, true}) {
    for (int i = 0; i < 2000; ++i) {
      const Sea sea = some_sea(places, 1 + i % 6, fades);
      const glm::dvec3 anchor = 3.0 * places.on_sphere();
      const glm::dvec3 q = std::pow(10.0, places.between(-3.0, 1.5)) * places.on_sphere();
      const glm::dvec3 v = glm::normalize(sea.r * glm::normalize(anchor) + q);
      double from_origin = 1.0;  // sine of the least arc from an origin or its antipode
      for (const Sea::Wave& w : sea.waves) {
        from_origin = std::fmin(from_origin, glm::length(glm::cross(v, glm::normalize(w.o))));
      }
      if (from_origin < 0.02) continue;  // differences by steps of 1e-5 say nothing there
      const auto answers = anchored(sea, anchor, q);
      const glm::dvec3 moved(answers[0], answers[1], answers[2]);
      ASSERT_LT(glm::distance(moved, surface(sea, v) - sea.r * v), 1e-11);
      const glm::dvec3 east = f64::perpendicular(v), north = glm::cross(v, east);
      const double h = 1e-5;
      const auto along = [&](const glm::dvec3& e) {
        const glm::dvec3 change =
            surface(sea, std::cos(h) * v + std::sin(h) * e) - surface(sea, std::cos(h) * v - std::sin(h) * e);
        return change / (2.0 * h * sea.r);
      };
      const glm::dvec3 n = glm::cross(along(east), along(north));
      ASSERT_NEAR(answers[6], glm::dot(n, v), 2e-5 / from_origin);
      if (glm::length(n) > 0.05) {
        ASSERT_LT(glm::distance(glm::dvec3(answers[3], answers[4], answers[5]), glm::normalize(n)), 5e-4);
      }
    }
  }
}

TEST(AnchoredWaves, DoNotDependOnTheAnchor) {
  Places places(282U);
  for (int i = 0; i < 500; ++i) {
    const Sea sea = some_sea(places, 3, true);
    const glm::dvec3 a = places.on_sphere(), b = glm::normalize(a + 0.2 * places.on_sphere());
    const glm::dvec3 place = sea.r * a + 2.0 * places.on_sphere();
    const auto one = anchored(sea, a, place - sea.r * a), other = anchored(sea, b, place - sea.r * b);
    for (std::size_t k = 0; k < 7; ++k) ASSERT_NEAR(one[k], other[k], 1e-9);
  }
}

TEST(AnchoredWaves, AreFiniteAtTheirOriginAndItsAntipode) {
  for (const double side : {1.0, -1.0}) {
    for (const bool fades : {false, true}) {
      const Sea sea{6.36e6, 3.0, fades, 0.0, 0.1, {{{0.0, 0.0, side}, 0.5, 0.3, 1.0, 0.8}}};
      const auto answers = anchored(sea, {0.0, 0.0, 6.36e6}, {0.0, 0.0, 0.0});
      for (const double x : answers) EXPECT_TRUE(std::isfinite(x));
      EXPECT_EQ(answers[0], 0.0);  // no direction, so no pinch
      EXPECT_EQ(answers[1], 0.0);
    }
  }
}

TEST(AnchoredWaves, HoldInSinglePrecisionOnTheEarthAfterThirtyYears) {
  Places places(283U);
  for (int i = 0; i < 500; ++i) {
    Sea sea = some_sea(places, 1, false);
    sea.r = 6.36e6;
    sea.t = 1e9;
    sea.waves[0].w = 2.0 * std::numbers::pi / 20.0;
    sea.waves[0].amplitude = 0.5;
    const double away = i % 2 == 0 ? 5.0 : 500.0;
    const glm::vec3 q(away * places.on_sphere());
    const auto numbers = probe::find_function("gerstner")->prepare(arguments(sea, places.on_sphere(), glm::dvec3(q)));
    std::vector<float> rounded(numbers->begin(), numbers->end());
    const auto single = probe::evaluate_f32("gerstner", rounded);
    const auto twice = probe::evaluate_f64("gerstner", *numbers);
    const double bound = (1e-5 + 16.0 * 0x1p-24 * sea.waves[0].w * away) * 0.5;
    for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(single[k], twice[k], 2.0 * bound);
  }
}

}  // namespace
}  // namespace terrella
