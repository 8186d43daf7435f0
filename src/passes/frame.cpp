#include "passes/frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "planet/rings.hpp"
#include "planet/spheres.hpp"
#include "planet/terrain.hpp"
#include "scene/color.hpp"

namespace terrella {
namespace {

glm::vec4 vector(const glm::dvec3& v, double w = 0.0) { return glm::vec4(glm::dvec4(v, w)); }

// An angle (rad) that grows with time without end, reduced to one turn before it is rounded.
double turned(double speed, double seconds) { return std::remainder(speed * seconds, 2.0 * std::numbers::pi); }

// Depth (planet radii) from which waves no longer feel the ground: a few of their heights, and so deep that at a place
// of less depth no trough reaches down to the ground. Waves are held by smoothstep(0, shoal, depth), which at a depth d
// is at most 9/8 d / shoal.
double shoal_of(const Frame& frame) {
  return std::max(4.0 * frame.scene.waves.amplitude / frame.scene.planet.radius, 1.125 * frame.sea.highest) + 1e-6;
}

glm::dvec3 linear(const Color& color) { return {linear_light(color.r), linear_light(color.g), linear_light(color.b)}; }

// Part of the sunlight that glows around the sun in the sky of the eye; none where that is outside of the air. sun:
// unit.
glm::dvec3 glow_at_eye(const Frame& frame, const glm::dvec3& sun) {
  const double distance = glm::length(frame.pose.eye), top = frame.scene.air.height / frame.scene.planet.radius;
  const double within = 1.0 - glm::smoothstep(0.7 * top, top, distance - 1.0);
  return within * f64::glow_of_sky(glm::dot(frame.pose.eye / distance, sun), linear(frame.scene.air.dusk_color));
}

}  // namespace

Sight sight_of(const Frame& frame) {
  // A little more than the picture, so that not every move of the camera changes what is drawn.
  return {frame.pose.eye, frame.pose.forward, picture_half_angle(frame.pose, frame.view) + 0.02};
}

double solid_radius(const Needs& needs) {
  const bool solid = needs.ground != Ground::none || needs.water != Water::none;
  return solid ? 1.0 - icosphere_sag(group_level) : 0.0;
}

RadiusRange water_range(const Frame& frame) {
  if (frame.needs.water == Water::none) return {};
  const double waves = frame.sea.highest;
  return {lowest_still_water(frame) - waves, water_radius(frame.scene) + frame.needs.water_lift + waves};
}

double lowest_still_water(const Frame& frame) {
  if (frame.needs.water == Water::none) return 0.0;
  return (water_radius(frame.scene) + frame.needs.water_lift) * (1.0 - icosphere_sag(frame.needs.water_level));
}

double map_level(const Frame& frame, double radius, double texel) {
  const double pixel = std::abs(glm::length(frame.pose.eye) - radius) * frame.pose.pixel_angle;
  return std::max(0.0, std::log2(std::max(pixel, 1e-12) / texel));
}

FrameBlock frame_block(const Frame& frame, const Maps& maps) {
  const auto& [scene, view, pose, needs, sea, channel, effort] = frame;
  const double aspect = static_cast<double>(view.width) / view.height;
  const glm::vec3 high(pose.eye);
  const double radius = scene.planet.radius;
  const double drift = turned(glm::radians(scene.clouds.drift), view.seconds);

  FrameBlock block;
  block.clip_from_eye = clip_from_eye(pose, view);
  block.eye_high = glm::vec4(high, static_cast<float>(glm::length(pose.eye) - 1.0));
  block.eye_low = vector(pose.eye - glm::dvec3(high));
  const glm::dvec2 shift = 2.0 * view.shift / glm::dvec2(view.width, -view.height);
  const glm::dvec3 right = aspect * pose.tan_half_fov * pose.right, up = pose.tan_half_fov * pose.up;
  block.ray_forward = vector(pose.forward - shift.x * right - shift.y * up, pose.pixel_angle);
  block.ray_right = vector(right);
  block.ray_up = vector(up);
  const glm::dvec3 sun = direction_of(scene.sun.latitude, scene.sun.longitude);
  block.sun_direction = vector(sun, std::exp2(scene.picture.exposure));
  const glm::dvec3 sunlight = linear(scene.sun.color) * (scene.sun.intensity * ring_shade_around(scene, pose.eye));
  block.sun_light = vector(sunlight);
  block.ground_map_scale = glm::vec4(maps.ground_texel, needs.pixel_octaves_first, needs.pixel_octaves_end,
                                     needs.water == Water::none ? 0.0 : 1.0);
  block.cloud_turn =
      glm::vec4(std::cos(drift), std::sin(drift), maps.cloud_level, needs.clouds == Clouds::none ? 0.0 : 1.0);
  block.cloud_moments = vector(maps.cloud_moments);
  block.sea = glm::vec4(has_water(scene) ? water_radius(scene) : 1.0, sea.highest,
                        static_cast<double>(sea.waves.size()), shoal_of(frame));
  block.ripple = glm::vec4(needs.ripple_layers > 0 ? scene.water.ripples : 0.0, icosphere_edge(needs.water_level),
                           needs.air == Air::none ? 0.0 : 1.0, 0.0);
  const double turn = turned(scene.water.ripple_speed, view.seconds);
  block.ripple_turn = glm::vec4(std::cos(turn), std::sin(turn), needs.ripple_layers, 0.0);
  block.water_extinction = vector(f64::extinction_of(linear(scene.water.tint)) * (radius / scene.water.clarity));
  // Where the sea freezes, snow lies on the ground.
  const double snow_sine = f64::polar_sine(scene.terrain.snow_latitude);
  const double ice_sine = has_ice(scene) ? f64::polar_sine(scene.water.ice_latitude) - 0.1 : snow_sine;
  block.levels = glm::vec4(std::min(snow_sine, ice_sine), needs.water_lift, maps.ground_level, 0.0);
  block.sky_glow = needs.air == Air::none ? glm::vec4(0.0F) : vector(sunlight * glow_at_eye(frame, sun));
  block.channel = glm::ivec4(static_cast<int>(channel), 0, 0, 0);
  return block;
}

}  // namespace terrella
