#include "planet/cube_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "formulas/formulas.hpp"

namespace terrella {
namespace {

constexpr double quarter_turn = 0.5 * std::numbers::pi;

// Where on its face something lies that is so far from the middle of its side, -1..1. Exact at the ends, where faces
// meet.
double place_on_face(double from_middle) {
  if (std::abs(from_middle) == 1.0) return from_middle;
  return std::tan(0.5 * quarter_turn * from_middle);
}

// The other way.
double part_of_face(double place) { return 0.5 + std::atan(place) / quarter_turn; }

// The face that a direction passes through, and where: cube_face_direction the other way.
struct FacePlace {
  int face;
  glm::dvec2 place;
};

FacePlace on_face(const glm::dvec3& d) {
  const glm::dvec3 size = glm::abs(d);
  if (size.x >= size.y && size.x >= size.z) {
    if (d.x > 0.0) return {0, {-d.z / size.x, -d.y / size.x}};
    return {1, {d.z / size.x, -d.y / size.x}};
  }
  if (size.y >= size.z) {
    if (d.y > 0.0) return {2, {d.x / size.y, d.z / size.y}};
    return {3, {d.x / size.y, -d.z / size.y}};
  }
  if (d.z > 0.0) return {4, {d.x / size.z, -d.y / size.z}};
  return {5, {-d.x / size.z, -d.y / size.z}};
}

}  // namespace

std::span<const GridNode> CubeGrid::roots() const {
  static constexpr std::array<GridNode, 6> roots = {{{0}, {1}, {2}, {3}, {4}, {5}}};
  return roots;
}

glm::dvec3 CubeGrid::direction_on(int face, double x, double y) const {
  const glm::dvec2 place(place_on_face(x), place_on_face(y));
  // Divided by a length that does not depend on which of both coordinates is which: the next face has them exchanged.
  const double length = std::sqrt(1.0 + (place.x * place.x + place.y * place.y));
  return f64::cube_face_direction(face, place) / length;
}

double CubeGrid::edge(int level) const {
  // In the middle of a face a place of 1 covers a radian; tangents spread by a quarter turn a side do so all along.
  return std::ldexp(quarter_turn, -level);
}

GridNode CubeGrid::node_at(const glm::dvec3& direction, int level) const {
  CHECK(level >= 0 && level <= deepest_level, level);
  const FacePlace found = on_face(direction);
  const double side = std::ldexp(1.0, level);
  const auto number = [&](double place) {
    return static_cast<std::uint32_t>(std::clamp(std::floor(part_of_face(place) * side), 0.0, side - 1.0));
  };
  return {found.face, level, number(found.place.x), number(found.place.y)};
}

std::optional<GridNode> CubeGrid::beyond_face(const GridNode& node, Side side) const {
  // Half a node beyond the edge of the cube, on the plane of this face. How far the place lies along the edge counts
  // there for less by as much as it lies beyond.
  const bool along_x = side == Side::left || side == Side::right;
  const bool upwards = side == Side::right || side == Side::top;
  const double beyond = std::tan(0.5 * quarter_turn * (1.0 + std::ldexp(1.0, -node.level)));
  const double beside = beyond * place_on_face(place_of_number(2.0 * (along_x ? node.y : node.x) + 1.0, node.level, 2));
  const double out = upwards ? beyond : -beyond;
  return node_at(f64::cube_face_direction(node.face, along_x ? glm::dvec2(out, beside) : glm::dvec2(beside, out)),
                 node.level);
}

}  // namespace terrella
