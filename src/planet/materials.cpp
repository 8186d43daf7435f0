#include "planet/materials.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "planet/linear_color.hpp"
#include "planet/rings.hpp"
#include "planet/spheres.hpp"
#include "planet/terrain.hpp"
#include "planet/water_medium.hpp"

namespace terrella {
namespace {

// Part of the sunlight that glows around the sun in the sky of the eye; none where that is outside of the air. sun:
// unit.
glm::dvec3 glow_at_eye(const Scene& scene, const glm::dvec3& eye, const glm::dvec3& sun) {
  const double distance = glm::length(eye), top = scene.air.height / scene.planet.radius;
  const double within = 1.0 - glm::smoothstep(0.7 * top, top, distance - 1.0);
  return within * f64::glow_of_sky(glm::dot(eye / distance, sun), linear(scene.air.dusk_color));
}

}  // namespace

bool has_air(const Scene& scene) { return scene.air.model != 0 && scene.air.density > 0.0 && scene.air.height > 0.0; }

bool has_clouds(const Scene& scene) {
  const auto& clouds = scene.clouds;
  return clouds.model != 0 && clouds.coverage > 0.0 && clouds.density > 0.0 && clouds.octaves > 0;
}

bool has_stars(const Scene& scene) {
  return scene.stars.model != 0 && scene.stars.density > 0.0 && scene.stars.brightness > 0.0;
}

f64::Air air_of(const Scene& scene) {
  f64::Air air;
  air.top = 1.0 + std::max(scene.air.height / scene.planet.radius, 1e-6);
  air.density = has_air(scene) ? scene.air.density : 0.0;
  air.exponent = scene.air.exponent;
  air.wrap = scene.air.wrap;
  air.color = linear(scene.air.color);
  air.dusk = linear(scene.air.dusk_color);
  return air;
}

f64::Bands bands_of(const Scene& scene) {
  const auto& from = scene.terrain;
  const double radius = scene.planet.radius;
  f64::Bands bands;
  bands.sand = linear(from.sand_color);
  bands.land = linear(from.land_color);
  bands.mountain = linear(from.mountain_color);
  bands.snow = linear(from.snow_color);
  bands.seabed = linear(from.seabed_color);
  bands.sea = water_look_of(scene).color;
  bands.sand_height = from.sand_height / radius;
  bands.mountain_height = from.mountain_height / radius;
  bands.snow_height = from.snow_height / radius;
  bands.softness = from.softness;
  bands.slope_rock = from.slope_rock;
  bands.thinning = from.thinning;
  bands.hollows = from.hollows;
  // Where the sea freezes, snow lies on the ground.
  bands.snow_sine = f64::polar_sine(from.snow_latitude);
  if (has_ice(scene)) bands.snow_sine = std::min(bands.snow_sine, f64::polar_sine(scene.water.ice_latitude) - 0.1);
  return bands;
}

f64::Clouds clouds_of(const Scene& scene) {
  const auto& from = scene.clouds;
  f64::Clouds clouds;
  clouds.height = from.height / scene.planet.radius;
  clouds.thickness = from.thickness / scene.planet.radius;
  clouds.coverage = from.coverage;
  clouds.softness = from.softness;
  clouds.density = from.density;
  clouds.shadow = from.shadow;
  clouds.color = linear(from.color);
  return clouds;
}

f64::WaterLook water_look_of(const Scene& scene) {
  const auto& from = scene.water;
  f64::WaterLook look;
  if (const auto medium = medium_of(scene)) {
    look.color = color_of_depths(*medium);
    look.extinction = extinction_of(*medium) * scene.planet.radius;
    look.clarity = 1.0 / look.extinction.g;
  } else {
    look.color = linear(from.color);
    look.extinction = f64::extinction_of(linear(from.tint)) * (scene.planet.radius / from.clarity);
    look.clarity = from.clarity / scene.planet.radius;
  }
  look.foam_color = linear(from.foam_color);
  look.foam = from.foam;
  look.roughness = from.roughness;
  look.refraction_index = from.refraction_index;
  look.shininess = from.shininess;
  look.glow = from.glow;
  look.crust = from.crust;
  look.shading = from.shading;
  return look;
}

glm::dvec2 turned(double speed, double seconds) {
  const double angle = std::remainder(speed * seconds, 2.0 * std::numbers::pi);
  return {std::cos(angle), std::sin(angle)};
}

f64::SceneLight light_of(const Scene& scene, const Pose& pose) {
  f64::SceneLight light;
  light.eye = pose.eye;
  light.eye_height = glm::length(pose.eye) - 1.0;
  light.sun = direction_of(scene.sun.latitude, scene.sun.longitude);
  light.sunlight = linear(scene.sun.color) * (scene.sun.intensity * ring_shade_around(scene, pose.eye));
  light.ambient = scene.sun.ambient;
  light.air = air_of(scene);
  light.sky_glow = has_air(scene) ? light.sunlight * glow_at_eye(scene, pose.eye, light.sun) : glm::dvec3(0.0);
  return light;
}

}  // namespace terrella
