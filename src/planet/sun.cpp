#include "planet/sun.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "formulas/formulas.hpp"

namespace terrella {
namespace {

glm::dvec3 sun_of(const Scene& scene) { return direction_of(scene.sun.latitude, scene.sun.longitude); }

}  // namespace

double seen_sun_radius(const Scene& scene) { return std::max(std::tan(0.5 * glm::radians(scene.sun.size)), 0.004); }

double pixel_at_sun(const Scene& scene, const Pose& pose) {
  constexpr double least = 1e-3;  // of one in the middle
  const double aside = std::max(glm::dot(pose.forward, sun_of(scene)), 0.0);
  return pose.pixel_angle * std::max(aside * aside, least);
}

double free_part_of_sun(const Scene& scene, const Pose& pose, double solid) {
  const double distance = glm::length(pose.eye);
  if (solid <= 0.0 || distance <= 0.0) return 1.0;
  const double planet = std::asin(std::min(1.0, solid / distance));
  const double beside = f64::angle_between(-pose.eye, sun_of(scene)) - planet;
  const double radius = 0.5 * glm::radians(std::max(scene.sun.size, 0.05));
  return glm::smoothstep(-radius, radius, beside);
}

bool sun_in_picture(const Scene& scene, const View& view, const Pose& pose, bool with_glare) {
  const double reach = with_glare ? std::atan(f64::glare_reach) : 0.0;
  const double around = std::max(reach, 0.5 * glm::radians(scene.sun.size));
  return f64::angle_between(pose.forward, sun_of(scene)) < picture_half_angle(pose, view) + around;
}

}  // namespace terrella
