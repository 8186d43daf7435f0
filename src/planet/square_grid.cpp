#include "planet/square_grid.hpp"

#include <cmath>

#include "base/check.hpp"

namespace terrella {

double place_of_number(double number, int level, int cells) {
  const double all = std::ldexp(static_cast<double>(cells), level);
  return (2.0 * number - all) / all;  // only the quotient is rounded
}

std::array<GridNode, 4> SquareGrid::children_of(const GridNode& node) const {
  CHECK(node.level < deepest_level, node.level);
  const int level = node.level + 1;
  const std::uint32_t x = 2 * node.x, y = 2 * node.y;
  return {{{node.face, level, x, y},
           {node.face, level, x + 1, y},
           {node.face, level, x, y + 1},
           {node.face, level, x + 1, y + 1}}};
}

GridNode SquareGrid::parent_of(const GridNode& node) const {
  CHECK(node.level > 0, node.level);
  return {node.face, node.level - 1, node.x / 2, node.y / 2};
}

glm::dvec3 SquareGrid::vertex_direction(const GridNode& node, int i, int j, int cells) const {
  const double many = cells;
  return direction_on(node.face, place_of_number(many * node.x + i, node.level, cells),
                      place_of_number(many * node.y + j, node.level, cells));
}

std::optional<GridNode> SquareGrid::across(const GridNode& node, Side side) const {
  const std::uint32_t last = (1U << static_cast<unsigned>(node.level)) - 1U;
  GridNode next = node;
  switch (side) {
    case Side::left:
      if (node.x > 0) return --next.x, next;
      break;
    case Side::right:
      if (node.x < last) return ++next.x, next;
      break;
    case Side::bottom:
      if (node.y > 0) return --next.y, next;
      break;
    case Side::top:
      if (node.y < last) return ++next.y, next;
      break;
  }
  return beyond_face(node, side);
}

std::optional<GridNode> SquareGrid::beyond_corner(const GridNode& node, unsigned corner) const {
  const bool right = (corner & 1U) != 0, top = (corner & 2U) != 0;
  const std::uint32_t last = (1U << static_cast<unsigned>(node.level)) - 1U;
  const Side along_x = right ? Side::right : Side::left, along_y = top ? Side::top : Side::bottom;
  const bool leaves_by_x = node.x == (right ? last : 0), leaves_by_y = node.y == (top ? last : 0);
  // At the corners of faces there is none but those that are across sides.
  if (leaves_by_x && leaves_by_y) return std::nullopt;
  // Sides have other names on the next face, so the edge of this one comes last.
  const std::optional<GridNode> within = across(node, leaves_by_x ? along_y : along_x);
  return across(*within, leaves_by_x ? along_x : along_y);
}

NodesAround SquareGrid::around(const GridNode& node) const {
  NodesAround nodes;
  for (unsigned i = 0; i < 4; ++i) {
    if (const auto next = across(node, square_sides.at(i))) nodes.add(*next, first_side << i);
    if (const auto next = beyond_corner(node, i)) nodes.add(*next, first_corner << i);
  }
  return nodes;
}

}  // namespace terrella
