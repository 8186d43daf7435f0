#include "planet/node_outline.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace terrella {
namespace {

// Of a side: unit, away from the node. By the difference of its corners, which is exact however near they are.
glm::dvec3 normal_of(const NodeOutline& outline, std::size_t side) {
  const glm::dvec3& corner = outline.corners.at(side);
  const glm::dvec3 normal = glm::cross(corner, outline.corners.at((side + 1) % 4) - corner);
  const double length = glm::length(normal);
  if (length == 0.0) return glm::dvec3(0.0);  // the last of a triangle
  return (glm::dot(normal, outline.middle - corner) > 0.0 ? -1.0 : 1.0) / length * normal;
}

// How far a place lies beyond the plane of a side.
double beyond(const NodeOutline& outline, std::size_t side, const glm::dvec3& place) {
  return glm::dot(outline.outwards.at(side), place - outline.corners.at(side));
}

}  // namespace

NodeOutline outline_of(const NodeGrid& grid, const NodePatch& patch, const GridNode& node) {
  NodeOutline outline;
  outline.middle = grid.middle_of(node);
  const auto rim = [&](std::size_t k) {
    const NodePatch::Vertex& vertex = patch.vertices[patch.rim[k]];
    return grid.vertex_direction(node, vertex.i, vertex.j, patch.cells);
  };
  const auto cells = static_cast<std::size_t>(patch.cells);
  for (std::size_t side = 0; side < 4; ++side) outline.corners.at(side) = rim(side * cells % patch.rim.size());
  for (std::size_t side = 0; side < 4; ++side) outline.outwards.at(side) = normal_of(outline, side);
  for (std::size_t k = 0; k < patch.rim.size(); ++k) {
    const glm::dvec3 place = rim(k);
    outline.half_width = std::max(outline.half_width, glm::distance(place, outline.middle));
    outline.bulge = std::max(outline.bulge, std::abs(beyond(outline, k / cells, place)));
  }
  return outline;
}

double distance_to_line(const glm::dvec3& from, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 along = b - a;
  const double square = glm::dot(along, along);
  const double part = square > 0.0 ? std::clamp(glm::dot(from - a, along) / square, 0.0, 1.0) : 0.0;
  return glm::distance(from, a + part * along);
}

double nearest_to(const NodeOutline& outline, const glm::dvec3& direction) {
  bool within = true;
  double nearest = glm::distance(direction, outline.corners[0]);
  for (std::size_t side = 0; side < 4; ++side) {
    within = within && beyond(outline, side, direction) <= outline.bulge;
    nearest =
        std::min(nearest, distance_to_line(direction, outline.corners.at(side), outline.corners.at((side + 1) % 4)));
  }
  // A place on the other side of the sphere is within none.
  if (within && glm::dot(direction, outline.middle) > 0.0) return 0.0;
  return std::max(nearest - outline.bulge, 0.0);
}

double farthest_from(const NodeOutline& outline, const glm::dvec3& direction) {
  double farthest = 0.0;
  for (const glm::dvec3& corner : outline.corners) farthest = std::max(farthest, glm::distance(corner, direction));
  return farthest + outline.bulge;
}

bool is_outside(const NodeOutline& outline, double lowest, double highest, const glm::dvec3& eye,
                const glm::dvec3& inwards, double beyond) {
  // The flat lid over the corners touches the highest sphere in its middle.
  const double cosine = 1.0 - 0.5 * outline.half_width * outline.half_width;
  if (cosine < 0.5) return false;
  const double lid = highest / cosine, margin = outline.bulge * lid + beyond;
  const double from_eye = glm::dot(inwards, eye);
  return std::all_of(outline.corners.begin(), outline.corners.end(), [&](const glm::dvec3& corner) {
    const double along = glm::dot(inwards, corner);
    return along * lowest - from_eye < -margin && along * lid - from_eye < -margin;
  });
}

}  // namespace terrella
