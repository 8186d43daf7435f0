#include "measure/node_errors.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "measure/seen_places.hpp"

namespace terrella {
namespace {

class Chance {
 public:
  double part() { return static_cast<double>(random_()) / 4294967296.0; }

  glm::dvec3 place_in(const std::vector<glm::dvec3>& vertices, const std::vector<std::uint16_t>& triangles) {
    const std::size_t first = 3 * static_cast<std::size_t>(part() * static_cast<double>(triangles.size() / 3));
    // Uniform over the triangle.
    const double towards = std::sqrt(part()), along = part();
    const glm::dvec3 &a = vertices[triangles[first]], &b = vertices[triangles[first + 1]],
                     &c = vertices[triangles[first + 2]];
    return (1.0 - towards) * a + towards * ((1.0 - along) * b + along * c);
  }

 private:
  std::mt19937 random_{3U};
};

}  // namespace

std::vector<NodeError> node_errors(const NodePicture& picture, int places, double footprint) {
  const Pose& pose = picture.pose();
  const SeenPlaces seen(picture.scene(), picture.view(), pose, picture.needs());
  Chance chance;
  std::vector<NodeError> errors;
  const std::size_t in_each = static_cast<std::size_t>(places) / std::max<std::size_t>(picture.drawn().size(), 1) + 1;
  for (const DrawnNode& drawn : picture.drawn()) {
    if (!picture.shows(NodeLayer::ground, drawn)) continue;
    const std::vector<glm::dvec3> vertices = picture.vertices_of(drawn);
    const std::vector<std::uint16_t>& triangles = picture.triangles_of(drawn, NodePicture::Skirt::without);
    for (std::size_t i = 0; i < in_each; ++i) {
      const glm::dvec3 place = chance.place_in(vertices, triangles);
      if (!seen.is_seen(place)) continue;
      const double pixel = pose.pixel_angle * glm::distance(place, pose.eye), radius = glm::length(place);
      const glm::dvec3 up = place / radius;
      const double ground = 1.0 + f64::terrain_height_at(up, picture.terrain(), footprint * pixel).value;
      errors.push_back(
          {glm::distance(seen.pixel_of(place), seen.pixel_of(ground * up)), std::abs(radius - ground) / pixel});
    }
  }
  return errors;
}

}  // namespace terrella
