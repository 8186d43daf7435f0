#include "passes/frame.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "gl/caps.hpp"
#include "planet/cube_grid.hpp"
#include "planet/icosphere.hpp"
#include "planet/materials.hpp"
#include "planet/shores.hpp"
#include "planet/spheres.hpp"
#include "planet/terrain.hpp"

namespace terrella {
namespace {

glm::vec4 vector(const glm::dvec3& v, double w = 0.0) { return glm::vec4(glm::dvec4(v, w)); }

// How far apart samples of the ground are that a picture shows, rad: its texels or pixels, or pixels alone where those
// add what texels can't hold.
double finest_seen(const Frame& frame, const Maps& maps) {
  const double pixel = footprint_below(frame.scene, frame.pose);
  return refines_ground(frame.needs) ? pixel : std::max(pixel, maps.ground_texel);
}

// Part of a sea whose waves are not drawn that they whiten.
double white_from_afar(const Needs& needs, const Sea& sea) {
  if (needs.water != Water::calm || sea.is_calm()) return 0.0;
  return f64::whitecaps_at(1.0, 1.0, sea.slope_variance, sea.breaking);
}

// Whether the water has no slopes, shown or not.
bool is_smooth(const Scene& scene, const Needs& needs) {
  return needs.water == Water::calm && !needs.hides_waves && scene.water.ripples <= 0.0;
}

}  // namespace

double margin_of_rows(const Frame& frame) {
  constexpr double pixels = 8.0;
  return pixels * frame.pose.pixel_angle;
}

Sight sight_of(const Frame& frame) {
  // A little more than the picture, so that not every move of the camera changes what is drawn.
  return {frame.pose.eye, frame.pose.forward, picture_half_angle(frame.pose, frame.view) + 0.02,
          sides_of(frame.pose, frame.view, frame.rows, frame.pose.pixel_angle)};
}

double solid_radius(const Needs& needs) {
  const bool solid = needs.ground != Ground::none || needs.water != Water::none;
  if (!solid) return 0.0;
  if (!has_nodes(needs.ground)) return 1.0 - icosphere_sag(group_level);
  // Across the diagonal of a cell of the coarsest nodes: those of a grid around a far eye are nearly three times as
  // wide as a cube's.
  const double widest = needs.ground == Ground::persistent_grid ? 3.0 : 1.0;
  const double spacing = widest * CubeGrid().spacing(0, needs.ground_cells);
  return 1.0 - spacing * spacing / 4.0;
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
  const double pixel =
      std::abs(glm::length(frame.pose.eye) - radius) * frame.pose.pixel_angle * footprint_of_pixel(frame.scene);
  return std::max(0.0, std::log2(std::max(pixel, 1e-12) / texel));
}

FrameBlock frame_block(const Frame& frame, const Maps& maps) {
  const auto& [scene, view, pose, needs, sea, channel, effort, rows, making_ms, levels_for, ground_shown, mirror,
               is_mirror] = frame;
  const double aspect = static_cast<double>(view.width) / view.height;
  const glm::vec3 high(pose.eye);
  const f64::SceneLight light = light_of(scene, pose);
  const glm::dvec2 drift = turned(glm::radians(scene.clouds.drift), view.seconds);

  FrameBlock block;
  const DepthScheme depths = depth_scheme(pose, gl::caps().clip_control);
  block.clip_from_eye = clip_from_eye(pose, view, depths);
  block.eye_high = glm::vec4(high, static_cast<float>(light.eye_height));
  block.eye_low = vector(pose.eye - glm::dvec3(high));
  const glm::dvec2 shift = 2.0 * view.shift / glm::dvec2(view.width, -view.height);
  const glm::dvec3 right = aspect * pose.tan_half_fov * pose.right, up = pose.tan_half_fov * pose.up;
  block.ray_forward = vector(pose.forward - shift.x * right - shift.y * up, pose.pixel_angle);
  block.ray_right = vector(right);
  block.ray_up = vector(up, needs.mirrored_land);
  block.sun_direction = vector(light.sun, std::exp2(scene.picture.exposure));
  block.sun_light = vector(light.sunlight);
  block.ground_map_scale = glm::vec4(maps.ground_texel, needs.pixel_octaves_first, needs.pixel_octaves_end,
                                     needs.water == Water::none ? 0.0 : 1.0);
  block.cloud_turn = glm::vec4(drift, maps.cloud_level, needs.clouds == Clouds::none ? 0.0 : 1.0);
  block.cloud_moments = vector(maps.cloud_moments);
  block.sea = glm::vec4(has_water(scene) ? water_radius(scene) : 1.0, sea.amplitude, drawn_long_waves(sea),
                        whole_wave_depth(sea));
  block.ripple = glm::vec4(needs.ripple_layers > 0 ? scene.water.ripples : 0.0, icosphere_edge(needs.water_level),
                           needs.water == Water::calm ? sea.slope_variance : 0.0, 0.0);
  block.ripple_turn = glm::vec4(turned(scene.water.ripple_speed, view.seconds), needs.ripple_layers, 0.0);
  const f64::WaterLook water = water_look_of(scene);
  block.water_extinction = vector(water.extinction, wet_height(scene, sea));
  block.water_depths = vector(water.color, water.clarity);
  block.levels = glm::vec4(bands_of(scene).snow_sine, needs.water_lift, maps.ground_level, needs.water_most_lift);
  block.slopes = glm::vec4(unseen_slopes(scene, finest_seen(frame, maps)), unseen_slopes(scene, needs.ground_spacing),
                           white_from_afar(needs, sea), is_smooth(scene, needs) ? 1.0 : 4.0);
  block.sky_glow = vector(light.sky_glow);
  // Points of light have their size in the picture that is shown; where fewer pixels are drawn they are as small as can
  // be, and dimmer for it.
  block.fineness = glm::vec4(footprint_of_pixel(scene), scene.quality.ground_texel_size, std::max(view.scale, 1.0),
                             std::pow(std::min(view.scale, 1.0), 2.0));
  block.depth = glm::vec4(depths.far_plane, depths.log_factor, pose.near, mirror != nullptr ? mirror->climb : 0.0);
  block.lens = vector(lens_above_water(pose), std::max(water_radius(scene) - glm::length(pose.eye), 0.0));
  if (mirror != nullptr) {
    block.mirror_from_eye = clip_in_mirror(*mirror);
    const double climb = depth_of_climb(*mirror);
    // Depths are 0 to 1 in the end, whichever they are drawn as.
    const double drawn = is_mirror ? (gl::caps().clip_control ? 1.0 : 2.0) * climb : 0.0;
    block.mirror = glm::vec4(mirror->height, mirror->pose.pixel_angle, climb, drawn);
  } else {
    block.mirror_from_eye = glm::mat4(0.0F);
    block.mirror = glm::vec4(0.0F);
  }
  if (is_mirror) block.clip_from_eye = block.mirror_from_eye;
  block.channel = glm::ivec4(static_cast<int>(channel), 0, 0, 0);
  return block;
}

}  // namespace terrella
