#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

f64::Air air() {
  f64::Air a;
  a.top = 1.14;
  a.density = 0.85;
  a.exponent = 3.2;
  a.wrap = 0.22;
  a.color = glm::dvec3(0.2, 0.4, 1.0);
  a.dusk = glm::dvec3(1.0, 0.3, 0.1);
  return a;
}

// The cosine with which a ray that passes the centre at a distance meets the shell's edge.
double cosine_at(double distance, double top) {
  return std::sqrt(std::fmax(0.0, 1.0 - distance * distance / (top * top)));
}

TEST(FresnelAlpha, IsClearHeadOnAndOpaqueAlongTheEdge) {
  EXPECT_EQ(f64::fresnel_alpha(1.0, 3.0), 0.0);
  EXPECT_EQ(f64::fresnel_alpha(0.0, 3.0), 1.0);
  EXPECT_EQ(f64::fresnel_alpha(1.0, 0.0), 1.0);  // 0^0 is 1
  EXPECT_EQ(f64::fresnel_alpha(1.0000003, 2.5), 0.0);
  EXPECT_EQ(f64::fresnel_alpha(-0.2, 2.5), 1.0);
}

TEST(AirPath, EndsOnTheShell) {
  Places places(51U);
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 eye = places.on_sphere() * places.between(1.0, 5.0), ray = places.on_sphere();
    const f64::AirPath path = f64::air_path(eye, ray, 1.14);
    ASSERT_GE(path.enter, 0.0);
    ASSERT_GE(path.leave, path.enter);
    if (path.leave > path.enter) {
      ASSERT_NEAR(glm::length(eye + path.leave * ray), 1.14, 1e-12);
      if (path.enter > 0.0) {
        ASSERT_NEAR(glm::length(eye + path.enter * ray), 1.14, 1e-12);
      }
      const glm::dvec3 edge = glm::normalize(eye + path.leave * ray);
      ASSERT_NEAR(path.cosine, glm::dot(edge, ray), 1e-9);
    }
  }
}

TEST(AirOpacity, IsGreatestAtTheLimbAndNothingAtItsOuterEdge) {
  const f64::Air a = air();
  EXPECT_NEAR(f64::air_opacity(cosine_at(1.0, a.top), a), a.density, 1e-9);
  EXPECT_NEAR(f64::air_opacity(cosine_at(a.top, a.top), a), 0.0, 1e-9);
  EXPECT_LT(f64::air_opacity(cosine_at(a.top - 1e-4, a.top), a), 1e-3);
  double before = 0.0;
  for (double distance = 0.0; distance <= 1.0; distance += 0.01) {
    const double opacity = f64::air_opacity(cosine_at(distance, a.top), a);
    EXPECT_GE(opacity, before - 1e-12);
    before = opacity;
  }
  before = a.density;
  for (double distance = 1.0; distance <= a.top; distance += 0.001) {
    const double opacity = f64::air_opacity(cosine_at(distance, a.top), a);
    EXPECT_LE(opacity, before + 1e-12);
    before = opacity;
  }
}

TEST(AirOpacity, OfAPartGrowsWithThePartUpToTheWhole) {
  const f64::Air a = air();
  const double cosine = cosine_at(0.9, a.top);
  EXPECT_EQ(f64::air_opacity_before(0.6, cosine, 0.0, a.top), 0.0);
  double before = 0.0;
  for (double path = 0.0; path < 3.0; path += 0.01) {
    const double opacity = f64::air_opacity_before(0.6, cosine, path, a.top);
    EXPECT_GE(opacity, before);
    before = opacity;
  }
  EXPECT_NEAR(before, 0.6, 1e-9);
}

// Half of the way has half of the depth: over the limb that is half of the chord, before the ground all up to it.
TEST(AirOpacity, OfHalfTheWayLeavesTheRootOfWhatTheWholeLeaves) {
  const double top = 1.14, half = 1.0 - std::sqrt(1.0 - 0.6);
  const double chord = 2.0 * std::sqrt(top * top - 1.05 * 1.05);
  EXPECT_NEAR(f64::air_opacity_before(0.6, cosine_at(1.05, top), 0.5 * chord, top), half, 1e-9);
  const double to_ground = std::sqrt(top * top - 0.9 * 0.9) - std::sqrt(1.0 - 0.9 * 0.9);
  EXPECT_NEAR(f64::air_opacity_before(0.6, cosine_at(0.9, top), to_ground, top), half, 1e-9);
}

TEST(AirOpacity, OfAPartChangesSmoothlyOverTheLimb) {
  const f64::Air a = air();
  const auto opacity = [&](double distance) {
    const double cosine = cosine_at(distance, a.top);
    return f64::air_opacity_before(f64::air_opacity(cosine, a), cosine, 0.3, a.top);
  };
  EXPECT_NEAR(opacity(1.0 - 1e-7), opacity(1.0 + 1e-7), 1e-3);
}

TEST(AirLight, IsDarkInTheNightAndTheAirsColorByDay) {
  const f64::Air a = air();
  const glm::dvec3 sun(1.0, 0.0, 0.0);
  EXPECT_EQ(f64::air_light(glm::dvec3(-1.0, 0.0, 0.0), sun, a), glm::dvec3(0.0));
  const glm::dvec3 noon = f64::air_light(sun, sun, a);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(noon[c], a.color[c], 1e-12);
  const glm::dvec3 dusk = f64::air_light(glm::normalize(glm::dvec3(0.01, 1.0, 0.0)), sun, a);
  EXPECT_GT(dusk.x / dusk.z, 2.0 * noon.x / noon.z);  // warmer
}

TEST(SkyPastAir, IsWholeOutsideAndFadesInTheOuterQuarter) {
  const double top = 1.2;
  const glm::dvec3 eye(3.0, 0.0, 0.0);
  const auto shown = [&](double nearest) {
    const double sine = nearest / eye.x;
    return f64::sky_past_air(eye, glm::dvec3(-std::sqrt(1.0 - sine * sine), sine, 0.0), top);
  };
  EXPECT_EQ(shown(1.21), 1.0);
  EXPECT_EQ(f64::sky_past_air(eye, glm::dvec3(1.0, 0.0, 0.0), top), 1.0);  // away from the planet
  EXPECT_NEAR(shown(1.2 - 1e-9), 1.0, 1e-6);
  EXPECT_NEAR(shown(1.175), 0.5, 1e-9);
  for (double nearest = 1.0; nearest < 1.2; nearest += 0.01) EXPECT_LE(shown(nearest), shown(nearest + 0.01));
  EXPECT_EQ(shown(1.149), 0.0);
  EXPECT_EQ(shown(0.5), 0.0);
  // An eye just within it, who looks out, has only what is above behind the air.
  EXPECT_NEAR(f64::sky_past_air({1.175, 0.0, 0.0}, glm::dvec3(1.0, 0.0, 0.0), top), 0.5, 1e-9);
  EXPECT_NEAR(f64::sky_past_air({1.2 - 1e-9, 0.0, 0.0}, glm::dvec3(1.0, 0.0, 0.0), top), 1.0, 1e-6);
}

TEST(GlowOfSky, IsStrongestAndRedUnderALowSunAndNoneAtNight) {
  const glm::dvec3 dusk = air().dusk;
  const glm::dvec3 low = f64::glow_of_sky(0.05, dusk), high = f64::glow_of_sky(1.0, dusk);
  EXPECT_EQ(f64::glow_of_sky(-0.3, dusk), glm::dvec3(0.0));
  EXPECT_EQ(high, glm::dvec3(0.25));  // white: the sun itself
  EXPECT_GT(low.r, 4.0 * high.r);
  EXPECT_GT(low.r, 2.0 * low.b);
  for (double climb = -1.0; climb < 1.0; climb += 0.01) {
    const glm::dvec3 step = f64::glow_of_sky(climb + 0.01, dusk) - f64::glow_of_sky(climb, dusk);
    EXPECT_LT(glm::length(step), 0.2) << climb;
  }
}

TEST(WideGlow, IsHalfTowardsTheSunAndNoneBesideIt) {
  EXPECT_EQ(f64::wide_glow(1.0), 0.5);
  EXPECT_EQ(f64::wide_glow(0.0), 0.0);
  EXPECT_EQ(f64::wide_glow(-1.0), 0.0);
  EXPECT_NEAR(f64::wide_glow(0.8), 0.5 * std::pow(0.8, 6.0), 1e-12);
}

}  // namespace
}  // namespace terrella
