// What rays from a picture's eye meet of the triangles that it is drawn with. Lengths in planet radii.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "measure/node_picture.hpp"

namespace terrella {

class NodeRays {
 public:
  // picture: of the ground's nodes without skirts; kept.
  explicit NodeRays(const NodePicture& picture);

  // What is told of the ground at the first triangle that turns to the eye along a ray from it, unit; nothing where
  // none does.
  [[nodiscard]] std::optional<ToldGround> first_along(const glm::dvec3& ray) const;

 private:
  struct Node {
    std::vector<ToldGround> vertices;
    std::span<const std::uint16_t> triangles;  // three vertices each
    glm::dvec3 centre;                         // of a sphere around them, from the eye
    double radius;
  };
  struct Hit {
    double distance;
    const Node* node;
    std::size_t triangle;
    glm::dvec3 parts;  // of its corners
  };
  void find_in(const Node& node, const glm::dvec3& ray, std::optional<Hit>& nearest) const;

  glm::dvec3 eye_;
  std::vector<Node> nodes_;
};

}  // namespace terrella
