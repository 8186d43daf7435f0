#include "measure/node_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "measure/seen_places.hpp"
#include "measure/skyline.hpp"

namespace terrella {
namespace {

class Chance {
 public:
  double part() { return static_cast<double>(random_()) / 4294967296.0; }

  // Corners of one of a node's.
  std::array<glm::dvec3, 3> triangle_of(const std::vector<glm::dvec3>& vertices,
                                        const std::vector<std::uint16_t>& triangles) {
    const std::size_t first = 3 * static_cast<std::size_t>(part() * static_cast<double>(triangles.size() / 3));
    return {vertices[triangles[first]], vertices[triangles[first + 1]], vertices[triangles[first + 2]]};
  }

  // Uniform over a triangle.
  glm::dvec3 place_in(const std::array<glm::dvec3, 3>& corners) {
    const double towards = std::sqrt(part()), along = part();
    return (1.0 - towards) * corners[0] + towards * ((1.0 - along) * corners[1] + along * corners[2]);
  }

 private:
  std::mt19937 random_{3U};
};

// Twice the triangle's area, outwards.
glm::dvec3 normal_of(const std::array<glm::dvec3, 3>& corners) {
  return glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
}

bool turns_to(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& eye) {
  return glm::dot(normal_of(corners), eye - corners[0]) > 0.0;
}

// That a triangle covers which is as far away as one of its places.
double pixels_of(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& place, const Pose& pose) {
  const glm::dvec3 to_eye = pose.eye - place;
  const double distance = glm::length(to_eye), pixel = pose.pixel_angle * distance;
  return 0.5 * std::abs(glm::dot(normal_of(corners), to_eye)) / (distance * pixel * pixel);
}

}  // namespace

double percentile(std::vector<NodeError> errors, double NodeError::*of, double part) {
  CHECK(!errors.empty());
  std::sort(errors.begin(), errors.end(), [&](const NodeError& a, const NodeError& b) { return a.*of < b.*of; });
  double all = 0.0;
  for (const NodeError& error : errors) all += error.pixels;
  double below = 0.0;
  for (const NodeError& error : errors) {
    below += error.pixels;
    if (below >= part * all) return error.*of;
  }
  return errors.back().*of;
}

std::vector<NodeError> node_errors(const NodePicture& picture, int places, double footprint) {
  const Pose& pose = picture.pose();
  const SeenPlaces seen(picture.scene(), picture.view(), pose, picture.needs());
  GroundSkyline skyline(pose.eye);
  Chance chance;
  std::vector<NodeError> errors;
  const std::size_t in_each = static_cast<std::size_t>(places) / std::max<std::size_t>(picture.drawn().size(), 1) + 1;
  for (const DrawnNode& drawn : picture.drawn()) {
    if (!picture.shows(NodeLayer::ground, drawn)) continue;
    const std::vector<glm::dvec3> vertices = picture.vertices_of(drawn);
    const std::vector<std::uint16_t>& triangles = picture.triangles_of(drawn, NodePicture::Skirt::without);
    const double in_a_place = static_cast<double>(triangles.size() / 3) / static_cast<double>(in_each);
    for (std::size_t i = 0; i < in_each; ++i) {
      const std::array<glm::dvec3, 3> corners = chance.triangle_of(vertices, triangles);
      const glm::dvec3 place = chance.place_in(corners);
      if (!seen.is_seen(place) || !turns_to(corners, pose.eye) || skyline.hides(place)) continue;
      const double pixel = pose.pixel_angle * glm::distance(place, pose.eye), radius = glm::length(place);
      const glm::dvec3 up = place / radius;
      const double ground = 1.0 + f64::terrain_height_at(up, picture.terrain(), footprint * pixel).value;
      const double pixels = in_a_place * pixels_of(corners, place, pose);
      errors.push_back(
          {glm::distance(seen.pixel_of(place), seen.pixel_of(ground * up)), std::abs(radius - ground) / pixel, pixels});
    }
    skyline.add(vertices, triangles);
  }
  return errors;
}

}  // namespace terrella
