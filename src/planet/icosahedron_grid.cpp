#include "planet/icosahedron_grid.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/check.hpp"

namespace terrella {
namespace {

constexpr int ring = 5;  // vertices around a pole, and rhombi at it

bool is_upper(const GridNode& node) { return node.face % 2 != 0; }
int rhombus_of(const GridNode& node) { return node.face / 2; }
GridNode half_of(int rhombus, bool upper, int level, std::uint32_t x, std::uint32_t y) {
  return {2 * rhombus + (upper ? 1 : 0), level, x, y};
}

// Corner of the northern ring (0) or the southern one (1), which is turned by half a step.
glm::dvec3 on_ring(int number, int which) {
  const double turn = 2.0 * std::numbers::pi * (number % ring + 0.5 * which) / ring;
  const double high = 1.0 / std::sqrt(5.0);
  return {2.0 * high * std::cos(turn), 2.0 * high * std::sin(turn), which == 0 ? high : -high};
}

// Corners of a rhombus: where both are least, x is most, y is most, both are. From its first corner on,
// counter-clockwise from outside, come the second, the last and the third.
using Rhombus = std::array<glm::dvec3, 4>;

std::array<Rhombus, 10> make_rhombi() {
  const glm::dvec3 north(0.0, 0.0, 1.0), south(0.0, 0.0, -1.0);
  std::array<Rhombus, 10> rhombi;
  for (int k = 0; k < ring; ++k) {
    rhombi.at(static_cast<std::size_t>(k)) = {north, on_ring(k, 0), on_ring(k + 1, 0), on_ring(k, 1)};
    rhombi.at(static_cast<std::size_t>(ring + k)) = {on_ring(k + 1, 0), on_ring(k, 1), on_ring(k + 1, 1), south};
  }
  return rhombi;
}

const Rhombus& rhombus(int number) {
  static const std::array<Rhombus, 10> rhombi = make_rhombi();
  return rhombi.at(static_cast<std::size_t>(number));
}

// Of a corner, at a part of the way (0..1) to it from the opposite side: sines divide the sides evenly, so that
// triangles of a level differ little in size.
double weight(double part) {
  static const double arc = std::atan(2.0);  // of a side
  return std::sin(part * arc);
}

}  // namespace

std::span<const GridNode> IcosahedronGrid::roots() const {
  static const auto roots = [] {
    std::array<GridNode, 4 * ring> all;
    for (int face = 0; face < 4 * ring; ++face) all.at(static_cast<std::size_t>(face)).face = face;
    return all;
  }();
  return roots;
}

std::array<GridNode, 4> IcosahedronGrid::children_of(const GridNode& node) const {
  CHECK(node.level < deepest_level, node.level);
  const int r = rhombus_of(node), level = node.level + 1;
  const std::uint32_t x = 2 * node.x, y = 2 * node.y;
  const bool upper = is_upper(node);
  const std::uint32_t tip = upper ? 1 : 0;  // the cell in which the node has both of its halves
  return {half_of(r, upper, level, x + tip, y + tip), half_of(r, upper, level, x + 1, y),
          half_of(r, upper, level, x, y + 1),
          upper ? half_of(r, false, level, x + 1, y + 1) : half_of(r, true, level, x, y)};
}

GridNode IcosahedronGrid::parent_of(const GridNode& node) const {
  CHECK(node.level > 0, node.level);
  const bool odd_x = node.x % 2 != 0, odd_y = node.y % 2 != 0;
  // In two of the four cells both halves belong to the same half of the cell above.
  const bool upper = odd_x == odd_y ? odd_x : is_upper(node);
  return half_of(rhombus_of(node), upper, node.level - 1, node.x / 2, node.y / 2);
}

glm::dvec3 IcosahedronGrid::vertex_direction(const GridNode& node, int i, int j, int cells) const {
  const double many = cells, all = std::ldexp(many, node.level);
  const bool upper = is_upper(node);
  // From the first corner of the rhombus; whole numbers, so that all but the quotients is exact.
  const double x = many * node.x + (upper ? many - i : i), y = many * node.y + (upper ? many - j : j);
  const Rhombus& corners = rhombus(rhombus_of(node));
  // In the half of the whole rhombus that holds the node, which on the diagonal between them makes no difference.
  const bool high = x + y > all;
  const double tip = weight((high ? x + y - all : all - x - y) / all), along_x = weight((high ? all - y : x) / all),
               along_y = weight((high ? all - x : y) / all);
  // Along a side one weight is 0, and the sum of the other two does not depend on their order.
  return glm::normalize(tip * corners[high ? 3 : 0] + (along_x * corners[1] + along_y * corners[2]));
}

double IcosahedronGrid::edge(int level) const {
  // Within a face the sines' sides are longer than along the icosahedron's, by less than this (measured by
  // node_grid_test).
  return std::ldexp(1.178 * std::atan(2.0), -level);
}

IcosahedronGrid::Across IcosahedronGrid::across(const GridNode& node, unsigned side) {
  const int r = rhombus_of(node);
  const bool upper = is_upper(node);
  const auto last = (std::uint32_t{1} << static_cast<unsigned>(node.level)) - 1U;
  const auto [x, y] = std::pair(node.x, node.y);
  const auto other = [&](int rhombus, std::uint32_t at_x, std::uint32_t at_y) {
    return half_of(rhombus, !upper, node.level, at_x, at_y);
  };
  if (side == 0) return {other(r, x, y), 0};
  // Sides 1 and 2 are left and below of lower halves, right and above of upper ones.
  const bool by_x = side == 1;
  if (by_x ? (upper ? x < last : x > 0) : (upper ? y < last : y > 0)) {
    const std::uint32_t step = upper ? 1U : ~0U;
    return {by_x ? other(r, x + step, y) : other(r, x, y + step), side};
  }
  const bool north = r < ring;
  const int k = r % ring, before = (k + ring - 1) % ring, after = (k + 1) % ring;
  if (north && upper) return by_x ? Across{other(ring + before, 0, y), 1} : Across{other(ring + k, x, 0), 2};
  if (!north && !upper) return by_x ? Across{other(after, last, y), 1} : Across{other(k, x, last), 2};
  // At the poles, where rhombi of a ring meet, x of one is y of the next.
  const int base = north ? 0 : ring;
  const bool onwards = by_x == north;
  const std::uint32_t rim = upper ? last : 0;
  const std::uint32_t next_x = by_x ? y : rim, next_y = by_x ? rim : x;
  return {half_of(base + (onwards ? after : before), upper, node.level, next_x, next_y), by_x ? 2U : 1U};
}

NodesAround IcosahedronGrid::around(const GridNode& node) const {
  NodesAround nodes;
  for (unsigned side = 0; side < 3; ++side) nodes.add(across(node, side).node, first_side << side);
  // Around each corner, but for the node itself and those across its sides there: two or three.
  for (unsigned corner = 0; corner < 3; ++corner) {
    const GridNode end = across(node, (corner + 2) % 3).node;
    Across next = across(node, (corner + 1) % 3);
    for (int n = 0; n < 3; ++n) {
      // The side by which one came has the corner at its beginning here: the other side that has it is the second from
      // it.
      next = across(next.node, (next.side + 2) % 3);
      if (next.node == end) break;
      nodes.add(next.node, first_corner << corner);
    }
  }
  return nodes;
}

}  // namespace terrella
