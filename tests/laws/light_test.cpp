#include <gtest/gtest.h>

#include <vector>

#include "formulas/formulas.hpp"
#include "laws/equal.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::expect_equal;
using test::Places;

constexpr double top = 1.1;

f64::SceneLight scene_from(const glm::dvec3& eye, const glm::dvec3& sun) {
  f64::SceneLight scene;
  scene.eye = eye;
  scene.eye_height = glm::length(eye) - 1.0;
  scene.sun = sun;
  scene.sunlight = {2.0, 1.8, 1.5};
  scene.ambient = 0.1;
  scene.sky_glow = {0.3, 0.2, 0.1};
  scene.air = {top, 0.8, 3.2, 0.22, {0.2, 0.4, 1.0}, {1.0, 0.3, 0.1}};
  return scene;
}

f64::SceneLight without_air(f64::SceneLight scene) {
  scene.air.density = 0.0;
  return scene;
}

const glm::dvec3 sun(0.0, 0.0, 1.0);

// A place over which the sun stands so high.
glm::dvec3 place_under(double climb) { return {std::sqrt(1.0 - climb * climb), 0.0, climb}; }

// A ray from an eye that passes the planet's centre at a distance.
glm::dvec3 ray_past(double eye_distance, double nearest) {
  const double sine = nearest / eye_distance;
  return {sine, 0.0, -std::sqrt(1.0 - sine * sine)};
}

TEST(LightAt, AtTheZenithIsTheSunlightItself) {
  const f64::SceneLight scene = scene_from({0.0, 0.0, 3.0}, sun);
  for (const double climb : {0.3, 0.6, 1.0}) {
    const f64::LightAt at = f64::light_at(place_under(climb), 0.0, scene);
    expect_equal(at.sun, scene.sunlight);
    expect_equal(at.up, place_under(climb));
    expect_equal(at.air, scene.sunlight * f64::air_light(place_under(climb), sun, scene.air));
  }
}

// Whoever stands h over the ground sees sqrt(2 h) below the horizon, and the disc has a size.
TEST(LightAt, IsGoneBelowTheHorizonWhichLiesLowerForWhatStandsHigher) {
  const f64::SceneLight scene = scene_from({0.0, 0.0, 3.0}, sun);
  for (const double height : {0.0, 0.005, 0.02}) {
    const double horizon = -std::sqrt(2.0 * height) - 0.02;
    EXPECT_EQ(f64::light_at(place_under(horizon - 1e-9), height, scene).sun, glm::dvec3(0.0));
    EXPECT_GT(f64::light_at(place_under(horizon + 1e-3), height, scene).sun.r, 0.0);
  }
  EXPECT_EQ(f64::light_at(place_under(-0.03), -0.5, scene).sun, glm::dvec3(0.0));  // below the sphere as on it
}

TEST(LightAt, GrowsAndWhitensAsTheSunClimbs) {
  const f64::SceneLight scene = scene_from({0.0, 0.0, 3.0}, sun);
  const glm::dvec3 white = scene.sunlight;
  glm::dvec3 before(0.0);
  for (double climb = -0.019; climb < 0.4; climb += 1e-3) {
    const glm::dvec3 light = f64::light_at(place_under(climb), 0.0, scene).sun / white;
    EXPECT_GE(light.b, before.b);
    EXPECT_LE(light.b, light.g + 1e-12);
    EXPECT_LE(light.g, light.r + 1e-12);
    EXPECT_LT(glm::distance(light, before), 0.025) << climb;  // no step at the terminator
    if (before.b > 0.0) {
      EXPECT_LE(light.r / light.b, before.r / before.b + 1e-12);
    }
    before = light;
  }
}

// Of a sun on the horizon so much has given way to the colour of dusk, in proportion to the air.
TEST(LightAt, TakesTheColorOfDuskAsFarAsThereIsAir) {
  f64::SceneLight scene = scene_from({0.0, 0.0, 3.0}, sun);
  const glm::dvec3 white = f64::light_at(place_under(0.0), 0.0, without_air(scene)).sun;
  EXPECT_NEAR(white.r / white.b, scene.sunlight.r / scene.sunlight.b, 1e-12);
  for (const double density : {0.3, 1.0}) {
    scene.air.density = density;
    const glm::dvec3 taken = (white - f64::light_at(place_under(0.0), 0.0, scene).sun) / white;
    expect_equal(taken, 0.62 * density * (glm::dvec3(1.0) - 1.1 * scene.air.dusk));
  }
}

TEST(Skylight, ComesFromAllAroundAndMoreFromAbove) {
  const f64::SceneLight scene = scene_from({0.0, 0.0, 3.0}, sun);
  const glm::dvec3 up = place_under(0.5), side = glm::cross(up, glm::dvec3(0.0, 1.0, 0.0));
  const f64::LightAt at = f64::light_at(up, 0.0, scene);
  const glm::dvec3 above = f64::skylight(at, up, scene), below = f64::skylight(at, -up, scene);
  expect_equal(below, scene.sunlight * scene.ambient * glm::dvec3(0.32, 0.40, 0.62));
  expect_equal(above - below, 0.22 * scene.air.density * at.air);
  expect_equal(f64::skylight(at, side, scene), 0.5 * (above + below));
  expect_equal(f64::skylight(at, up, without_air(scene)), below);
}

TEST(LightOfAir, GlowsAroundTheSun) {
  const f64::SceneLight scene = scene_from({0.0, 0.0, 3.0}, sun);
  const f64::LightAt at = f64::light_at(place_under(0.5), 0.0, scene);
  expect_equal(f64::light_of_air(at, -sun, scene), 0.55 * at.air);
  expect_equal(f64::light_of_air(at, sun, scene), 0.55 * at.air + 0.5 * scene.sky_glow);
}

TEST(SkyAlong, IsThickestAlongTheHorizon) {
  const f64::SceneLight scene = scene_from({0.0, 0.0, 3.0}, sun);
  const glm::dvec3 up(1.0, 0.0, 0.0);  // rays at right angles to the sun: no glow
  const f64::LightAt at = f64::light_at(up, 0.0, scene);
  const auto along = [&](double sine) {
    return f64::sky_along(at, {sine, std::sqrt(1.0 - sine * sine), 0.0}, scene).g;
  };
  EXPECT_NEAR(along(0.0), scene.air.density * 0.55 * at.air.g, 1e-12);
  EXPECT_NEAR(along(1.0), 0.22 * along(0.0), 1e-12);
  EXPECT_EQ(along(-0.5), along(0.0));
  for (double sine = 0.0; sine < 0.98; sine += 0.01) EXPECT_GT(along(sine), along(sine + 0.01));
  expect_equal(f64::sky_along(at, up, without_air(scene)), glm::dvec3(0.0));
}

TEST(ThroughAir, IsTheLightItselfWhereThereIsNoneBefore) {
  const f64::SceneLight scene = scene_from({0.0, 0.0, 3.0}, sun);
  const f64::LightAt at = f64::light_at(place_under(0.5), 0.0, scene);
  const glm::dvec3 light(0.5, 0.6, 0.7);
  expect_equal(f64::through_air(light, at, {0.0, 0.0, -1.9}, scene), light);  // not yet in the shell
  expect_equal(f64::through_air(light, at, {0.0, 0.0, 9.0}, scene), light);   // away from the planet
  expect_equal(f64::through_air(light, at, {0.0, 0.0, -2.0}, without_air(scene)), light);
}

TEST(ThroughAir, HidesByTheWayInTheAirAndNotBeforeIt) {
  Places places(301U);
  for (int i = 0; i < 2000; ++i) {
    const double away = places.between(1.2, 5.0);
    const glm::dvec3 ray = ray_past(away, places.between(0.0, 1.09));
    const f64::SceneLight scene = scene_from({0.0, 0.0, away}, places.on_sphere());
    const f64::LightAt at = f64::light_at(places.on_sphere(), 0.0, scene);
    const f64::AirPath path = f64::air_path(scene.eye, ray, top);
    const double way = (path.leave - path.enter) * places.between(0.0, 1.0);
    const glm::dvec3 offset = (path.enter + way) * ray;
    // What is left of a light shows by its absence.
    const glm::dvec3 dark = f64::through_air(glm::dvec3(0.0), at, offset, scene);
    const glm::dvec3 left = f64::through_air(glm::dvec3(1.0, 2.0, 3.0), at, offset, scene) - dark;
    ASSERT_NEAR(left.y, 2.0 * left.x, 1e-12);
    ASSERT_NEAR(left.z, 3.0 * left.x, 1e-12);
    const double whole = f64::air_opacity(path.cosine, scene.air);
    ASSERT_NEAR(1.0 - left.x, f64::air_opacity_before(whole, path.cosine, way, top), 1e-12);
    ASSERT_LE(glm::distance(dark, (1.0 - left.x) * f64::light_of_air(at, ray, scene)), 1e-12);
    // From further back along the ray, but still on this side of the planet, it looks the same.
    f64::SceneLight further = scene;
    further.eye = scene.eye - 0.7 * ray;
    ASSERT_LE(glm::distance(f64::through_air(glm::dvec3(0.3), at, offset + 0.7 * ray, further),
                            f64::through_air(glm::dvec3(0.3), at, offset, scene)),
              1e-9);
  }
}

TEST(AirBeforeSky, FromOutsideIsTheShellAloneAndContinuousAtItsEdge) {
  const f64::SceneLight scene = scene_from({0.0, 0.0, 3.0}, {1.0, 0.0, 0.0});
  for (double nearest = 1.0; nearest < 1.1; nearest += 0.01) {
    const glm::dvec3 ray = ray_past(3.0, nearest);
    const f64::Veil veil = f64::air_before_sky(ray, scene);
    const double cosine = f64::air_path(scene.eye, ray, top).cosine;
    EXPECT_NEAR(veil.opacity, f64::air_opacity(cosine, scene.air), 1e-4);  // whose depths end at 1e-4 of the light
  }
  EXPECT_LT(f64::air_before_sky(ray_past(3.0, 1.1 - 1e-7), scene).opacity, 1e-6);
  EXPECT_EQ(f64::air_before_sky(ray_past(3.0, 1.1 + 1e-7), scene).opacity, 0.0);
  EXPECT_EQ(f64::air_before_sky({0.0, 0.0, 1.0}, scene).opacity, 0.0);
  EXPECT_EQ(f64::air_before_sky(ray_past(3.0, 1.05), without_air(scene)).opacity, 0.0);
}

TEST(AirBeforeSky, HasALeastOpacityOverhead) {
  f64::SceneLight scene = scene_from({0.0, 0.0, 1.0}, {1.0, 0.0, 0.0});
  double before = 2.0;
  for (double sine = 0.0; sine <= 1.0; sine += 0.01) {
    const double opacity = f64::air_before_sky({std::sqrt(1.0 - sine * sine), 0.0, sine}, scene).opacity;
    EXPECT_LE(opacity, before);
    EXPECT_GE(opacity, 0.1 * scene.air.density);
    before = opacity;
  }
  EXPECT_NEAR(f64::air_before_sky({0.0, 0.0, 1.0}, scene).opacity, 0.1 * scene.air.density, 1e-3);
  scene.air.density = 1.0;
  EXPECT_LE(f64::air_before_sky({1.0, 0.0, 0.0}, scene).opacity, 1.0);
}

TEST(AirBeforeSky, ChangesWithoutAStepAsTheEyeLeavesTheAir) {
  for (const double sine : {1.0, 0.3, -0.1}) {
    const glm::dvec3 ray(std::sqrt(1.0 - sine * sine), 0.0, sine);
    double before = -1.0;
    for (double height = 0.08; height < 0.11; height += 1e-5) {
      const double opacity = f64::air_before_sky(ray, scene_from({0.0, 0.0, 1.0 + height}, sun)).opacity;
      if (before >= 0.0) {
        ASSERT_LT(std::fabs(opacity - before), 5e-3) << sine << " " << height;
      }
      before = opacity;
    }
  }
}

TEST(AirBeforeSky, IsLitWhereTheRayComesNearestToThePlanet) {
  const glm::dvec3 ray = ray_past(3.0, 1.05);
  const glm::dvec3 eye(0.0, 0.0, 3.0), nearest = glm::normalize(eye - glm::dot(eye, ray) * ray);
  f64::SceneLight scene = scene_from(eye, nearest);
  const f64::Veil veil = f64::air_before_sky(ray, scene);
  expect_equal(veil.light, veil.opacity * 0.55 * scene.sunlight * scene.air.color);  // noon there
  scene.sun = -nearest;
  EXPECT_EQ(f64::air_before_sky(ray, scene).light, glm::dvec3(0.0));
  // From within, looking up, that is where the eye is.
  scene = scene_from({0.0, 0.0, 1.0}, sun);
  scene.sky_glow = glm::dvec3(0.0);
  const f64::Veil zenith = f64::air_before_sky(sun, scene);
  expect_equal(zenith.light, zenith.opacity * 0.55 * scene.sunlight * scene.air.color);
}

TEST(AirBeforeSky, GlowsTowardsTheSun) {
  const glm::dvec3 eye(0.0, 0.0, 1.0);
  f64::SceneLight scene = scene_from(eye, {1.0, 0.0, 0.0});
  const glm::dvec3 ray = scene.sun;
  const f64::Veil with = f64::air_before_sky(ray, scene);
  scene.sky_glow = glm::dvec3(0.0);
  const f64::Veil without = f64::air_before_sky(ray, scene);
  expect_equal((with.light - without.light) / with.opacity, 1.5 * glm::dvec3(0.3, 0.2, 0.1));
  scene = scene_from(eye, {-1.0, 0.0, 0.0});
  EXPECT_LT(f64::air_before_sky(ray, scene).light.r, 0.5 * with.light.r);
}

TEST(SkyShown, IsAllWithoutAirAndOutsideOfIt) {
  const f64::SceneLight scene = scene_from({0.0, 0.0, 3.0}, sun);
  EXPECT_EQ(f64::sky_shown({0.0, 0.0, -1.0}, without_air(scene)), 1.0);
  EXPECT_EQ(f64::sky_shown(ray_past(3.0, 1.11), scene), 1.0);
  EXPECT_EQ(f64::sky_shown(ray_past(3.0, 1.0), scene), 0.0);
  EXPECT_NEAR(f64::sky_shown(ray_past(3.0, 1.0875), scene), 0.5, 1e-9);  // in the middle of the outer quarter
}

TEST(SkyShown, FromTheGroundIsTheNightsAndAboveTheHorizon) {
  const glm::dvec3 eye(0.0, 0.0, 1.0);
  const auto shown = [&](double climb, double sine) {
    const glm::dvec3 direction(std::sqrt(1.0 - sine * sine), 0.0, sine);
    return f64::sky_shown(direction, scene_from(eye, {0.0, std::sqrt(1.0 - climb * climb), climb}));
  };
  EXPECT_EQ(shown(-0.25, 1.0), 1.0);
  EXPECT_NEAR(shown(0.1, 1.0), std::exp(-6.0 * 0.8), 1e-12);
  for (double climb = -0.5; climb < 0.5; climb += 0.01) EXPECT_LE(shown(climb + 0.01, 1.0), shown(climb, 1.0));
  EXPECT_EQ(shown(-0.5, 0.0), 0.0);
  EXPECT_NEAR(shown(-0.5, 0.15), 0.5, 1e-9);
  EXPECT_EQ(shown(-0.5, 0.3), 1.0);
}

TEST(SkyShown, ChangesWithoutAStepAsTheEyeLeavesTheAir) {
  for (const double sine : {1.0, 0.3, -0.1}) {
    const glm::dvec3 direction(std::sqrt(1.0 - sine * sine), 0.0, sine);
    double before = -1.0;
    for (double height = 0.08; height < 0.11; height += 1e-5) {
      const double shown = f64::sky_shown(direction, scene_from({0.0, 0.0, 1.0 + height}, sun));
      if (before >= 0.0) {
        ASSERT_LT(std::fabs(shown - before), 5e-3) << sine << " " << height;
      }
      before = shown;
    }
    if (sine > 0.0) {
      EXPECT_EQ(before, 1.0);
    }
  }
}

TEST(SunlightAtEye, IsThatOfThePlaceOnTheGroundAndWholeBesideThePlanet) {
  expect_equal(f64::sunlight_at_eye(scene_from({0.0, 0.0, 1.0}, sun)), {2.0, 1.8, 1.5});
  expect_equal(f64::sunlight_at_eye(scene_from({0.0, 0.0, -1.01}, sun)), glm::dvec3(0.0));
  const f64::SceneLight dusk = scene_from(place_under(0.0), sun);
  expect_equal(f64::sunlight_at_eye(dusk), f64::light_at(place_under(0.0), 0.0, dusk).sun);
  // In front of the planet nothing lies between.
  expect_equal(f64::sunlight_at_eye(scene_from({0.5, 0.0, 3.0}, sun)), {2.0, 1.8, 1.5});
  // Behind it, over the air.
  expect_equal(f64::sunlight_at_eye(scene_from({1.1, 0.0, -3.0}, sun)), {2.0, 1.8, 1.5});
}

TEST(SunlightAtEye, ReddensAsItGrazesTheLimb) {
  const auto light = [](double lowest, double density) {
    f64::SceneLight scene = scene_from({lowest, 0.0, -3.0}, sun);
    scene.air.density = density;
    return f64::sunlight_at_eye(scene) / scene.sunlight;
  };
  expect_equal(light(1.0, 1.0), glm::dvec3(0.2) + 0.8 * glm::dvec3(1.0, 0.3, 0.1));
  expect_equal(light(1.0, 0.5), glm::dvec3(0.6) + 0.4 * glm::dvec3(1.0, 0.3, 0.1));
  expect_equal(light(1.0, 0.0), glm::dvec3(1.0));
  for (double lowest = 1.0; lowest < 1.1; lowest += 0.01) EXPECT_LT(light(lowest, 0.8).b, light(lowest + 0.01, 0.8).b);
}

glm::dmat3 turned(Places& places) {
  const glm::dvec3 x = places.on_sphere(), y = glm::normalize(glm::cross(x, places.on_sphere()));
  return {x, y, glm::cross(x, y)};
}

// Nothing of all this knows where a scene's axes point, and everything is in proportion to the sun.
TEST(Light, IsTheSameHoweverTheSceneIsTurnedAndInProportionToTheSun) {
  Places places(302U);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 eye = places.between(1.0, 1.3) * places.on_sphere();
    const glm::dvec3 up = places.on_sphere(), normal = places.on_sphere(), ray = places.on_sphere();
    const f64::SceneLight scene = scene_from(eye, places.on_sphere());
    const glm::dmat3 turn = turned(places);
    const auto all = [&](const f64::SceneLight& s, const glm::dmat3& t) {
      const f64::LightAt at = f64::light_at(t * up, 0.01, s);
      const f64::Veil veil = f64::air_before_sky(t * ray, s);
      return std::vector<glm::dvec3>{at.sun,
                                     at.air,
                                     f64::skylight(at, t * normal, s),
                                     f64::light_of_air(at, t * ray, s),
                                     f64::sky_along(at, t * ray, s),
                                     f64::through_air(glm::dvec3(0.0), at, 0.3 * (t * ray), s),
                                     veil.light,
                                     f64::sunlight_at_eye(s),
                                     glm::dvec3(veil.opacity, f64::sky_shown(t * ray, s), 0.0)};
    };
    f64::SceneLight other = scene, brighter = scene;
    other.eye = turn * scene.eye;
    other.sun = turn * scene.sun;
    brighter.sunlight *= 2.0;
    brighter.sky_glow *= 2.0;
    const auto is = all(scene, glm::dmat3(1.0)), as_turned = all(other, turn), twice = all(brighter, glm::dmat3(1.0));
    for (std::size_t k = 0; k < is.size(); ++k) {
      ASSERT_LE(glm::distance(is[k], as_turned[k]), 1e-7) << k;  // grazing rays: a root of a rounding
      if (k + 1 < is.size()) {
        ASSERT_LE(glm::distance(2.0 * is[k], twice[k]), 1e-12) << k;
      }
    }
  }
}

}  // namespace
}  // namespace terrella
