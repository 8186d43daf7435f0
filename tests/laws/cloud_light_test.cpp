#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/bare_scene.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

f64::Clouds some_clouds() {
  f64::Clouds c;
  c.height = 0.02;
  c.thickness = 0.004;
  c.coverage = 0.6;
  c.softness = 0.3;
  c.density = 0.9;
  c.shadow = 0.7;
  c.color = {0.9, 0.8, 0.7};
  return c;
}

const glm::dvec3 zenith(0.0, 0.0, 1.0);

glm::dvec3 sun_at(double climb) { return {std::sqrt(1.0 - climb * climb), 0.0, climb}; }

// At the zenith of the planet's axis, thick all over, lit so much more from where the light enters.
f64::CloudAt cloud(const glm::dvec3& sun, double rise, const f64::Clouds& clouds) {
  f64::CloudAt at = f64::cloud_place(zenith, sun, clouds);
  at.noise = 2.0;
  at.rise = rise;
  return at;
}

TEST(CloudPlace, SplitsTheSunIntoItsHeightAndItsWayAlongTheShell) {
  const f64::Clouds clouds = some_clouds();
  Places places(311U);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 up = places.on_sphere(), sun = places.on_sphere();
    const f64::CloudAt at = f64::cloud_place(up, sun, clouds);
    ASSERT_LT(glm::distance(at.climb * up + at.toward, sun), 1e-12);
    ASSERT_NEAR(glm::dot(at.toward, up), 0.0, 1e-12);
    ASSERT_EQ(at.noise, 0.0);
    ASSERT_EQ(at.rise, 0.0);
  }
}

TEST(CloudPlace, LightComesFromFurtherTheLowerTheSunUpToABound) {
  const f64::Clouds clouds = some_clouds();
  EXPECT_DOUBLE_EQ(f64::cloud_place(zenith, sun_at(1.0), clouds).reach, clouds.thickness);
  EXPECT_DOUBLE_EQ(f64::cloud_place(zenith, sun_at(0.5), clouds).reach, 2.0 * clouds.thickness);
  for (const double climb : {0.1, -0.5}) {
    EXPECT_DOUBLE_EQ(f64::cloud_place(zenith, sun_at(climb), clouds).reach, 5.0 * clouds.thickness);
  }
}

TEST(CloudEntry, LiesTowardsTheSunByTheReach) {
  const f64::Clouds clouds = some_clouds();
  for (const double climb : {0.1, 0.5, 0.9}) {
    const f64::CloudAt at = f64::cloud_place(zenith, sun_at(climb), clouds);
    const glm::dvec3 entry = f64::cloud_entry(at);
    EXPECT_NEAR(glm::length(entry), 1.0, 1e-15);
    EXPECT_NEAR(entry.x / entry.z, at.reach * std::sqrt(1.0 - climb * climb), 1e-15);
  }
  EXPECT_EQ(f64::cloud_entry(f64::cloud_place(zenith, zenith, clouds)), zenith);
}

TEST(CloudVeil, IsAsOpaqueAsItIsDenseAndFadesWhereItsShellIsSeenAlongItsEdge) {
  const f64::Clouds clouds = some_clouds();
  const f64::SceneLight scene = test::bare_scene(zenith);
  const auto opacity = [&](double cosine) {  // of the view with the shell's normal
    return f64::cloud_veil(cloud(zenith, 0.0, clouds), -sun_at(cosine), clouds, scene).opacity;
  };
  EXPECT_DOUBLE_EQ(opacity(1.0), clouds.density);
  EXPECT_DOUBLE_EQ(opacity(0.16), clouds.density);
  EXPECT_NEAR(opacity(0.08), 0.5 * clouds.density, 1e-12);
  EXPECT_EQ(opacity(0.0), 0.0);
  for (const double cosine : {0.05, 0.1, 0.7}) EXPECT_EQ(opacity(cosine), opacity(-cosine));
}

TEST(CloudVeil, IsNothingWithoutNoiseCoverageOrDensity) {
  const f64::SceneLight scene = test::bare_scene(zenith);
  f64::Clouds clouds = some_clouds();
  f64::CloudAt thin = cloud(zenith, 0.0, clouds);
  thin.noise = -2.0;
  const auto expect_none = [&](const f64::CloudAt& at) {
    const f64::Veil veil = f64::cloud_veil(at, -2.0 * zenith, clouds, scene);
    EXPECT_EQ(veil.opacity, 0.0);
    EXPECT_EQ(veil.light, glm::dvec3(0.0));
  };
  expect_none(thin);
  clouds.coverage = 0.0;
  expect_none(cloud(zenith, 0.0, clouds));
  clouds = some_clouds();
  clouds.density = 0.0;
  expect_none(cloud(zenith, 0.0, clouds));
}

// The sun's part of the light as a part of its most, face on.
double sunlit(double climb, double rise, double shadow, bool from_below) {
  f64::Clouds clouds = some_clouds();
  clouds.shadow = shadow;
  const f64::SceneLight scene = test::bare_scene(sun_at(climb));
  const f64::Veil veil =
      f64::cloud_veil(cloud(scene.sun, rise, clouds), (from_below ? 2.0 : -2.0) * zenith, clouds, scene);
  const glm::dvec3 light = veil.light / veil.opacity / (clouds.color * scene.sunlight);
  EXPECT_NEAR(light.r, light.g, 1e-12);
  EXPECT_NEAR(light.r, light.b, 1e-12);
  return light.r;
}

TEST(CloudVeil, WithoutShadowsIsHalfOfTheLightThatFallsOnIt) {
  EXPECT_NEAR(sunlit(1.0, 0.0, 0.0, false), 0.5, 1e-12);
  EXPECT_NEAR(sunlit(1.0, 0.4, 0.0, true), 0.5, 1e-12);
  EXPECT_NEAR(sunlit(0.4, 0.0, 0.0, false), 0.5 * 0.65 / 1.25, 1e-12);
  EXPECT_EQ(sunlit(-0.26, 0.0, 0.0, false), 0.0);
}

TEST(CloudVeil, ShadesItselfByWhatRisesTowardsTheSunAndByItsOwnDepth) {
  const double bright = sunlit(1.0, -1.0, 1.0, false);
  EXPECT_NEAR(bright, 0.5 * 1.25, 1e-12);  // light at its edge towards the sun
  EXPECT_EQ(sunlit(1.0, -0.07, 1.0, false), bright);
  EXPECT_NEAR(sunlit(1.0, 0.03, 1.0, false), bright * std::exp(-1.0), 1e-12);  // ten times the rise, from its edge on
  EXPECT_NEAR(sunlit(1.0, -1.0, 1.0, true), bright * std::exp(-1.5), 1e-12);
  for (double rise = -0.07; rise < 0.3; rise += 0.01) {
    EXPECT_GT(sunlit(1.0, rise, 1.0, false), sunlit(1.0, rise + 0.01, 1.0, false));
    EXPECT_NEAR(sunlit(1.0, rise, 0.5, false), 0.5 * (sunlit(1.0, rise, 0.0, false) + sunlit(1.0, rise, 1.0, false)),
                1e-12);
  }
}

TEST(CloudVeil, TakesTheLightOfTheSkyByNightToo) {
  const f64::Clouds clouds = some_clouds();
  f64::SceneLight scene = test::bare_scene(-zenith);
  scene.ambient = 0.3;
  const f64::Veil veil = f64::cloud_veil(cloud(-zenith, 0.0, clouds), -2.0 * zenith, clouds, scene);
  const f64::LightAt at = f64::light_at(zenith, clouds.height, scene);
  EXPECT_LT(glm::distance(veil.light / veil.opacity, 0.8 * clouds.color * f64::skylight(at, zenith, scene)), 1e-12);
}

TEST(CloudVeil, LiesBehindTheAirBeforeIt) {
  const f64::Clouds clouds = some_clouds();
  f64::SceneLight scene = test::bare_scene(zenith);
  scene.air.density = 1.0;
  const glm::dvec3 offset = 1.02 * glm::normalize(glm::dvec3(0.6, 0.0, 0.8)) - scene.eye;
  f64::CloudAt at = f64::cloud_place(glm::normalize(scene.eye + offset), zenith, clouds);
  at.noise = 2.0;
  f64::Clouds black = clouds;
  black.color = glm::dvec3(0.0);
  const f64::Veil veil = f64::cloud_veil(at, offset, black, scene);
  const f64::LightAt light = f64::light_at(at.up, clouds.height, scene);
  EXPECT_LT(glm::distance(veil.light, veil.opacity * f64::through_air(glm::dvec3(0.0), light, offset, scene)), 1e-12);
  EXPECT_GT(veil.light.b, 0.0);
}

TEST(CloudBeforeSun, LiesOnTheShellInTheSunsDirection) {
  const f64::Clouds clouds = some_clouds();
  Places places(312U);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 up = places.on_sphere(), sun = places.on_sphere();
    const glm::dvec3 place = places.between(0.9, 1.02) * up;
    const glm::dvec3 there = f64::cloud_before_sun(place, sun, clouds);
    ASSERT_NEAR(glm::length(there), 1.0, 1e-12);
    if (glm::dot(up, sun) <= 0.0) continue;  // no sun
    const glm::dvec3 way = (1.0 + clouds.height) * there - place;
    ASSERT_GE(glm::dot(way, sun), -1e-12);
    ASSERT_LT(glm::length(glm::cross(way, sun)), 1e-9);
  }
}

TEST(CloudShade, TakesInProportionToAllThatACloudIsAndNothingAboveIt) {
  f64::Clouds clouds = some_clouds();
  const glm::dvec3 below(0.0, 1.0, 0.0), above(0.0, 1.021, 0.0);
  EXPECT_EQ(f64::cloud_shade(above, 1.0, clouds), 1.0);
  EXPECT_EQ(f64::cloud_shade(below, 0.0, clouds), 1.0);
  const double taken = 1.0 - f64::cloud_shade(below, 1.0, clouds);
  EXPECT_NEAR(1.0 - f64::cloud_shade(below, 0.3, clouds), 0.3 * taken, 1e-15);
  EXPECT_NEAR(1.0 - f64::cloud_shade(0.99 * below, 1.0, clouds), taken, 1e-15);
  clouds.shadow = 0.0;
  EXPECT_EQ(f64::cloud_shade(below, 1.0, clouds), 1.0);
  clouds.shadow = clouds.density = 1.0;
  EXPECT_NEAR(f64::cloud_shade(below, 1.0, clouds), 0.15, 1e-15);  // the darkest: sky comes through
  clouds.density = 0.0;
  EXPECT_EQ(f64::cloud_shade(below, 1.0, clouds), 1.0);
}

}  // namespace
}  // namespace terrella
