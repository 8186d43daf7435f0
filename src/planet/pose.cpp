#include "planet/pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "formulas/formulas.hpp"
#include "planet/materials.hpp"
#include "planet/needs.hpp"
#include "planet/real_size.hpp"
#include "planet/rings.hpp"
#include "planet/shores.hpp"
#include "planet/short_waves.hpp"
#include "planet/spheres.hpp"
#include "planet/terrain.hpp"
#include "planet/waves.hpp"

namespace terrella {
namespace {

// Depths count along the middle of the picture: what lies at its edge has less of it than distance.
void set_depth_range(Pose& pose, const View& view, const Scene& scene) {
  const double top = top_radius(scene), rings = rings_radius(scene);
  const double distance = glm::length(pose.eye), outermost = std::max(top, rings);
  const auto to_horizon = [](double radius) { return f64::horizon_distance(1.0, std::max(radius - 1.0, 0.0)); };
  pose.far = 1.001 * (to_horizon(distance) + to_horizon(top)) + 2.0 * pose.clearance;
  if (rings > 0.0) pose.far = std::max(pose.far, 1.001 * (distance + rings));
  const double at_edge = std::cos(picture_half_angle(pose, view)), ahead = -glm::dot(pose.eye, pose.forward);
  // A part of the clearance to stay clear of hills beside the eye, and what is left of it over or under the clouds, but
  // no less than depths can bear where the eye passes through them; far away, the planet's nearest point.
  pose.near = 0.3 * std::min(1.0, at_edge / 0.7) * pose.nearest;
  if (has_clouds(scene)) {
    const double to_clouds = 0.9 * at_edge * std::abs(distance - cloud_radius(scene));
    pose.near = std::min(pose.near, std::max(to_clouds, 0.03 * pose.near));
  }
  pose.near = std::max({pose.near, 0.9 * at_edge * (distance - outermost), 0.9 * (ahead - outermost)});
  pose.near = std::min(pose.near, 0.5 * pose.far);
}

// Where a sphere begins and ends along one axis of the picture, as tangents. across, ahead: of its centre from the eye.
std::pair<double, double> extent(double across, double ahead, double radius) {
  constexpr double everything = 1e9;
  const double distance = std::hypot(across, ahead);
  if (distance <= radius) return {-everything, everything};
  const double middle = std::atan2(across, ahead), half = std::asin(radius / distance);
  const double right_angle = 0.5 * std::numbers::pi;
  return {middle - half > -right_angle ? std::tan(middle - half) : -everything,
          middle + half < right_angle ? std::tan(middle + half) : everything};
}

}  // namespace

glm::dvec3 direction_of(double latitude, double longitude) {
  const double lat = glm::radians(latitude), lon = glm::radians(longitude);
  return {std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)};
}

double least_clearance(const Scene& scene) {
  constexpr double of_meshes = 1e-4, of_nodes = 1e-6, metres = 0.2;
  if (!has_nodes(ground_technique(scene))) return of_meshes;
  return std::min(of_nodes, metres / scene.planet.radius);
}

namespace {

// Single precision, which tells places on an Earth 0.4 m apart, is enough for miniatures.
double ground_below(const Scene& scene, const glm::dvec3& direction) {
  constexpr double finest_of_meshes = 1e-7;
  if (!has_real_size) return ground_radius(terrain_of(scene), direction, finest_of_meshes);
  const bool nodes = has_nodes(ground_technique(scene));
  return exact_ground_radius(exact_terrain_of(scene), direction, nodes ? finest_footprint : finest_of_meshes);
}

// No crest of long waves is higher at a place, whatever the time. Shallow water holds waves back; but a crest leans
// aside by as much as it is high at the most, and comes from where the water is deeper by that times the slope of a
// shore.
double highest_sea(const Scene& scene, double ground) {
  const Sea sea = make_sea(scene, 0.0);
  constexpr double steep_shore = 0.25;
  double highest = 0.0;
  for (const f64::Wave& wave : sea.waves) highest += wave.amplitude;
  const double still = water_radius(scene), depth = still - ground + steep_shore * highest;
  return still + highest * glm::smoothstep(0.0, whole_wave_depth(sea), depth);
}

// The water that lies over a place.
struct WaterOver {
  double radius;
  glm::dvec3 normal;  // unit
};

// As its waves stand. sea: at a moment.
WaterOver water_over(const Scene& scene, const Sea& sea, const glm::dvec3& direction) {
  const double still = water_radius(scene);
  if (sea.is_calm()) return {still, direction};
  const double whole = whole_wave_depth(sea);
  f64::Shore shore = shore_of(scene, sea);
  shore.depth = has_ground(scene) ? still - ground_below(scene, direction) : whole;
  const NearWaves near = near_waves(sea, direction, shore.felt_depth);
  const double left = has_nodes(ground_technique(scene)) ? f64::left_ashore(shore.depth, whole)
                                                         : f64::left_by_ground(shore.depth, whole);
  const f64::WaveSum sum = f64::attenuate(waves_over(sea, near, shore), left, {0.0, 0.0});
  const glm::dvec3 normal = glm::normalize(f64::wave_normal(sum));
  return {still + sum.height, f64::normal_in_frame(normal, near.axes, direction)};
}

}  // namespace

double surface_radius(const Scene& scene, const glm::dvec3& direction) {
  const double ground = has_ground(scene) ? ground_below(scene, direction) : 1.0;
  double surface = ground;
  if (ground_technique(scene) == Ground::icosphere)
    surface = std::max(surface, drawn_ground_radius(terrain_of(scene), direction, ground_level(scene)));
  if (has_water(scene) && !scene.water.dive) surface = std::max(surface, highest_sea(scene, ground));
  return surface;
}

View whole_of(const View& view) {
  if (!view.whole) return view;
  View all = view;
  all.width = view.whole->width;
  all.height = view.whole->height;
  all.field = view.whole->field;
  all.shift = glm::dvec2(0.0);
  all.whole.reset();
  return all;
}

View drawn_at(View shown, double scale, int most) {
  View drawn = shown;
  drawn.scale = std::min(scale, static_cast<double>(most) / std::max(shown.width, shown.height));
  const auto pixels = [&](int count) { return std::max(1, static_cast<int>(count * drawn.scale + 0.5)); };
  drawn.width = pixels(shown.width);
  drawn.height = pixels(shown.height);
  drawn.shift *= glm::dvec2(drawn.width, drawn.height) / glm::dvec2(shown.width, shown.height);
  if (shown.whole) drawn.whole = {pixels(shown.whole->width), pixels(shown.whole->height), shown.whole->field};
  return drawn;
}

namespace {

Pose pose_over(double surface, const Scene& scene, const View& view) {
  const auto& camera = scene.camera;
  const glm::dvec3 down_from = direction_of(camera.latitude, camera.longitude);
  const double asked = 1.0 + camera.altitude / scene.planet.radius;
  const double distance = std::max(asked, surface + least_clearance(scene));

  Pose pose;
  pose.raised = asked < distance;
  pose.eye = distance * down_from;
  pose.clearance = pose.nearest = distance - surface;
  pose.over_water = std::numeric_limits<double>::infinity();
  pose.water_normal = down_from;

  // East and north from the longitude itself: they are defined at the poles, too.
  const double lon = glm::radians(camera.longitude);
  const glm::dvec3 east(-std::sin(lon), std::cos(lon), 0.0);
  const glm::dvec3 north = glm::cross(down_from, east);
  const double heading = glm::radians(camera.heading), pitch = glm::radians(camera.pitch);
  const glm::dvec3 ahead = std::cos(heading) * north + std::sin(heading) * east;
  pose.forward = std::cos(pitch) * ahead + std::sin(pitch) * down_from;
  const glm::dvec3 level = std::cos(heading) * east - std::sin(heading) * north;
  const double roll = glm::radians(camera.roll);
  pose.right = std::cos(roll) * level - std::sin(roll) * glm::cross(level, pose.forward);
  pose.up = glm::cross(pose.right, pose.forward);
  pose.tan_half_fov = view.field * std::tan(0.5 * glm::radians(camera.fov));
  pose.pixel_angle = 2.0 * pose.tan_half_fov / view.height;
  set_depth_range(pose, view, scene);
  return pose;
}

// Tells where the water is that may pass over the eye.
void let_dive(Pose& pose, const Scene& scene, const View& view) {
  if (!scene.water.dive || !has_water(scene)) return;
  const Sea sea = make_sea(scene, view.seconds);
  const auto tell_water_below = [&](const glm::dvec3& place) {
    const double distance = glm::length(place);
    const WaterOver water = water_over(scene, sea, place / distance);
    pose.over_water = distance - water.radius;
    pose.water_normal = water.normal;
  };
  tell_water_below(pose.eye);
  // Eyes so high that no lens reaches down to the water are not in it, however far away their near plane is.
  if (pose.over_water > 4.0 * least_clearance(scene) + 2.0 * sea.highest) {
    pose.over_water = std::numeric_limits<double>::infinity();
    pose.nearest = std::min(pose.clearance, glm::length(pose.eye) - water_radius(scene) - sea.highest);
    return set_depth_range(pose, view, scene);
  }
  // A lens has its width.
  const double least = std::min(least_clearance(scene), pose.clearance);
  pose.nearest = std::clamp(std::abs(pose.over_water), least, pose.clearance);
  set_depth_range(pose, view, scene);
  tell_water_below(pose.eye + pose.near * pose.forward);
}

glm::dvec3 direction_below(const Scene& scene) { return direction_of(scene.camera.latitude, scene.camera.longitude); }

}  // namespace

Pose pose_of(const Scene& scene, const View& view) {
  const glm::dvec3 below = direction_below(scene);
  const double surface = surface_radius(scene, below);
  Pose pose = pose_over(surface, scene, view);
  let_dive(pose, scene, view);
  if (!has_real_size || !has_water(scene) || scene.water.dive) return pose;
  // Eyes between crests and troughs stay over the water, but are not raised for good.
  const Sea sea = make_sea(scene, view.seconds);
  if (!sea.short_waves.empty() && pose.clearance <= sea.highest) {
    const bool raised = pose.raised;
    pose = pose_over(std::max(surface, water_over(scene, sea, below).radius), scene, view);
    pose.raised = raised;
  }
  return pose;
}

Pose pose_over_coarse_ground(const Scene& scene, const View& view) {
  const glm::dvec3 below = direction_below(scene);
  const double coarse = drawn_ground_radius(terrain_of(scene), below, coarse_level);
  Pose pose = pose_over(std::max(surface_radius(scene, below), coarse), scene, view);
  let_dive(pose, scene, view);
  return pose;
}

glm::dvec3 lens_above_water(const Pose& pose) {
  if (!std::isfinite(pose.over_water)) return pose.forward;
  const double over = pose.over_water - pose.near * glm::dot(pose.forward, pose.water_normal);
  const glm::dvec3 normal = pose.near * pose.water_normal + over * pose.forward;
  const double length = glm::length(normal);
  // Where the water's surface lies on the lens itself.
  return length > 0.0 ? normal / length : pose.water_normal;
}

namespace {

// How far the corners of the lens are from its middle, and a little more.
double lens_reach(const Pose& pose, const View& view) {
  return 1.1 * pose.near * std::tan(std::min(picture_half_angle(pose, view), 1.56));
}

}  // namespace

bool is_in_water(const Pose& pose, const View& view) { return pose.over_water < lens_reach(pose, view); }
bool is_all_in_water(const Pose& pose, const View& view) { return pose.over_water < -lens_reach(pose, view); }

glm::dvec3 ray_through(const Pose& pose, const View& view, const glm::dvec2& pixel) {
  const double x = (2.0 * (pixel.x - view.shift.x) - view.width) / view.height;
  const double y = 1.0 - 2.0 * (pixel.y - view.shift.y) / view.height;
  return glm::normalize(pose.forward + pose.tan_half_fov * (x * pose.right + y * pose.up));
}

std::array<glm::dvec3, 2> sides_of(const Pose& pose, const View& view, const Rows& rows, double margin) {
  const auto angle = [&](int row) {
    return std::atan(pose.tan_half_fov * (2.0 * (row + view.shift.y) / view.height - 1.0));
  };
  std::array<glm::dvec3, 2> sides{};
  if (rows.first > 0) {
    const double below = angle(rows.first) - margin;
    sides[0] = std::cos(below) * pose.up - std::sin(below) * pose.forward;
  }
  if (rows.end < view.height) {
    const double above = angle(rows.end) + margin;
    sides[1] = std::sin(above) * pose.forward - std::cos(above) * pose.up;
  }
  return sides;
}

double picture_half_angle(const Pose& pose, const View& view) {
  // To the corner that a shift has moved furthest from the middle.
  const double x = view.width + 2.0 * std::abs(view.shift.x), y = view.height + 2.0 * std::abs(view.shift.y);
  return std::atan(pose.tan_half_fov * std::hypot(x, y) / view.height);
}

PictureBox box_of_sphere(const Pose& pose, const View& view, double radius) {
  const double ahead = -glm::dot(pose.eye, pose.forward);
  const auto [left, right] = extent(-glm::dot(pose.eye, pose.right), ahead, radius);
  const auto [bottom, top] = extent(-glm::dot(pose.eye, pose.up), ahead, radius);
  const auto part = [](double tangent, double edge, double shift) {
    return std::clamp(0.5 + 0.5 * tangent / edge + shift, 0.0, 1.0);
  };
  const double edge_y = pose.tan_half_fov, edge_x = edge_y * view.width / view.height;
  const double x = view.shift.x / view.width, y = -view.shift.y / view.height;
  return {part(left, edge_x, x), part(bottom, edge_y, y), part(right, edge_x, x), part(top, edge_y, y)};
}

double ground_top(const Scene& scene) {
  return has_ground(scene) ? 1.0 + scene.terrain.height / scene.planet.radius : 1.0;
}

double ice_top(const Scene& scene) {
  if (!has_ground(scene) || !has_ice(scene)) return 1.0;
  return water_radius(scene) + f64::ice_thickness(scene.terrain.height / scene.planet.radius);
}

double relief_top(const Scene& scene) {
  const double top = std::max(ground_top(scene), ice_top(scene));
  return has_water(scene) ? std::max(top, water_radius(scene) + make_sea(scene, 0.0).highest) : top;
}

double top_radius(const Scene& scene) {
  const double top = relief_top(scene);
  return scene.clouds.model != 0 ? std::max(top, cloud_radius(scene)) : top;
}

double outermost_radius(const Scene& scene) {
  return std::max({top_radius(scene), scene.air.model != 0 ? air_radius(scene) : 1.0, rings_radius(scene)});
}

namespace {

double pixel_over(double distance, const Pose& pose) {
  const double surface = glm::length(pose.eye) - distance;
  const double d = 1.0 + distance / surface;
  return pose.pixel_angle * surface * (d - 1.0) * (d + 1.0) / d;
}

}  // namespace

double pixel_of_height(const Pose& pose) { return pixel_over(pose.clearance, pose); }
double pixel_of_water_height(const Pose& pose) { return pixel_over(pose.nearest, pose); }

DepthScheme depth_scheme(const Pose& pose, bool from_zero) {
  if (from_zero) return {0.0, 1.0, 0.0, 0.0};
  constexpr double widest = 1e4;  // where floats next to 1 still tell a thousandth of a distance
  const double range = pose.far / pose.near;
  return {-1.0, 2.0, -1.0, range > widest ? 2.0 / std::log2(range) : 0.0};
}

glm::mat4 clip_from_eye(const Pose& pose, const View& view, const DepthScheme& depths) {
  const double fy = 1.0 / pose.tan_half_fov;
  const double fx = fy * view.height / view.width;
  const double shift_x = 2.0 * view.shift.x / view.width, shift_y = -2.0 * view.shift.y / view.height;
  glm::mat4 m(0.0F);
  for (int i = 0; i < 3; ++i) {
    m[i][0] = static_cast<float>(fx * pose.right[i] + shift_x * pose.forward[i]);
    m[i][1] = static_cast<float>(fy * pose.up[i] + shift_y * pose.forward[i]);
    m[i][2] = static_cast<float>(depths.scale * pose.forward[i]);
    m[i][3] = static_cast<float>(pose.forward[i]);
  }
  m[3][2] = static_cast<float>(depths.offset * pose.near);
  return m;
}

}  // namespace terrella
