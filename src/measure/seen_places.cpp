#include "measure/seen_places.hpp"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "planet/spheres.hpp"

namespace terrella {

SeenPlaces::SeenPlaces(const Scene& scene, const View& view, const Pose& pose, const Needs& needs)
    : pose_(pose),
      half_(0.5 * view.width, 0.5 * view.height),
      pixels_a_tan_(half_.y / pose.tan_half_fov),
      // A ground may touch the sphere of its lowest places, and triangles dip below it.
      solid_(needs.water != Water::none ? water_radius(scene) : 1.0 - 1e-6) {}

glm::dvec2 SeenPlaces::pixel_of(const glm::dvec3& place) const {
  const glm::dvec3 from_eye = place - pose_.eye;
  return pixels_a_tan_ / glm::dot(from_eye, pose_.forward) *
         glm::dvec2(glm::dot(from_eye, pose_.right), glm::dot(from_eye, pose_.up));
}

glm::dvec3 SeenPlaces::ray_to(const glm::dvec2& pixel) const {
  return glm::normalize(pixels_a_tan_ * pose_.forward + pixel.x * pose_.right + pixel.y * pose_.up);
}

bool SeenPlaces::is_hidden(const glm::dvec3& place) const {
  if (glm::length(place) < solid_) return true;
  const glm::dvec3 from_eye = place - pose_.eye;
  // Where the ray to the place is nearest to the planet's middle.
  const double nearest = -glm::dot(pose_.eye, from_eye) / glm::dot(from_eye, from_eye);
  return nearest > 0.0 && nearest < 1.0 && glm::length(pose_.eye + nearest * from_eye) < solid_;
}

bool SeenPlaces::is_seen(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const {
  const std::array<glm::dvec3, 3> corners = {a, b, c};
  if (glm::dot(glm::cross(b - a, c - a), pose_.eye - a) <= 0.0) return false;
  // All beyond one side of the picture: its planes through the eye, so that corners behind it need no place in it.
  const auto all_beyond = [&](const glm::dvec3& axis, double reach) {
    return std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
      const glm::dvec3 from_eye = corner - pose_.eye;
      return glm::dot(from_eye, axis) * pixels_a_tan_ > reach * glm::dot(from_eye, pose_.forward);
    });
  };
  if (all_beyond(pose_.right, half_.x) || all_beyond(-pose_.right, half_.x) || all_beyond(pose_.up, half_.y) ||
      all_beyond(-pose_.up, half_.y))
    return false;
  return !std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) { return is_hidden(corner); });
}

}  // namespace terrella
