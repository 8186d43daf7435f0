#include "measure/node_rays.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace terrella {

NodeRays::NodeRays(const NodePicture& picture) : eye_(picture.pose().eye) {
  for (const DrawnNode& drawn : picture.drawn()) {
    if (!picture.shows(NodeLayer::ground, drawn)) continue;
    Node node = {picture.told_by(drawn), picture.triangles_of(drawn, NodePicture::Skirt::without), {}, 0.0};
    node.centre = node.vertices[node.vertices.size() / 2].place - eye_;
    for (const ToldGround& vertex : node.vertices)
      node.radius = std::max(node.radius, glm::distance(vertex.place - eye_, node.centre));
    nodes_.push_back(std::move(node));
  }
}

std::optional<ToldGround> NodeRays::first_along(const glm::dvec3& ray) const {
  std::optional<Hit> nearest;
  for (const Node& node : nodes_) {
    const double along = glm::dot(node.centre, ray);
    const bool misses = glm::distance(along * ray, node.centre) > node.radius || along + node.radius < 0.0;
    if (!misses && !(nearest && along - node.radius > nearest->distance)) find_in(node, ray, nearest);
  }
  if (!nearest) return std::nullopt;
  const auto corner = [&](std::size_t n) -> const ToldGround& {
    return nearest->node->vertices[nearest->node->triangles[nearest->triangle + n]];
  };
  return between(corner(0), corner(1), corner(2), nearest->parts);
}

void NodeRays::find_in(const Node& node, const glm::dvec3& ray, std::optional<Hit>& nearest) const {
  for (std::size_t i = 0; i < node.triangles.size(); i += 3) {
    const glm::dvec3 a = node.vertices[node.triangles[i]].place - eye_;
    const glm::dvec3 b = node.vertices[node.triangles[i + 1]].place - eye_;
    const glm::dvec3 c = node.vertices[node.triangles[i + 2]].place - eye_;
    // Volumes between the ray and the edges: those that turn to the eye have all of them below zero.
    const glm::dvec3 parts(glm::dot(glm::cross(b, c), ray), glm::dot(glm::cross(c, a), ray),
                           glm::dot(glm::cross(a, b), ray));
    const double all = parts.x + parts.y + parts.z;
    if (parts.x > 0.0 || parts.y > 0.0 || parts.z > 0.0 || all >= 0.0) continue;
    const double distance = glm::dot(glm::cross(b - a, c - a), a) / all;
    if (distance > 0.0 && !(nearest && nearest->distance <= distance)) nearest = Hit{distance, &node, i, parts / all};
  }
}

}  // namespace terrella
