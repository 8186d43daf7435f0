#include "planet/mirror.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "planet/spheres.hpp"

namespace terrella {
namespace {

// Pixels along a side, at the most, and for each of the picture.
constexpr int most = 2048;
constexpr double fineness = 0.5;

}  // namespace

View mirror_view(const View& view) {
  View mirror = drawn_at(whole_of(view), fineness, most);
  mirror.shift.y = -mirror.shift.y;
  return mirror;
}

Mirror mirror_of(const Scene& scene, const Pose& pose, const View& view) {
  Mirror mirror = {mirror_view(view), pose, glm::length(pose.eye) - water_radius(scene)};
  const glm::dvec3 plumb = glm::normalize(pose.eye);
  const auto mirrored = [&](const glm::dvec3& axis) { return axis - 2.0 * glm::dot(axis, plumb) * plumb; };
  mirror.pose.forward = mirrored(pose.forward);
  mirror.pose.right = mirrored(pose.right);
  mirror.pose.up = -mirrored(pose.up);
  mirror.pose.tan_half_fov *= mirror.view.field / view.field;
  mirror.pose.pixel_angle = 2.0 * mirror.pose.tan_half_fov / mirror.view.height;
  return mirror;
}

glm::dvec3 mirrored_eye(const Mirror& mirror) {
  return mirror.pose.eye - 2.0 * mirror.height * glm::normalize(mirror.pose.eye);
}

glm::mat4 clip_in_mirror(const Mirror& mirror) {
  const glm::dvec3 from_mirrored_eye = mirror.pose.eye - mirrored_eye(mirror);
  return glm::translate(clip_from_eye(mirror.pose, mirror.view, {0.0, 0.0, 0.0, 0.0}), glm::vec3(from_mirrored_eye));
}

double depth_of_climb(const Mirror& mirror) { return 0.5 * std::cos(picture_half_angle(mirror.pose, mirror.view)); }

}  // namespace terrella
