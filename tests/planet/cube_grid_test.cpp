#include "planet/cube_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "laws/random_places.hpp"

namespace terrella {
namespace {

using test::Places;

constexpr int cells = 28;

// A node of a level at random.
QuadNode some_node(Places& places, int level) { return node_at(places.on_sphere(), level); }

TEST(CubeGrid, FindsTheNodeThatHoldsADirection) {
  Places places(1);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 direction = places.on_sphere();
    const QuadNode deep = node_at(direction, deepest_level);
    // Within a diagonal of the middle, which the angle of so small a chord is.
    EXPECT_LT(glm::distance(middle_of(deep), direction), 0.71 * node_edge(deepest_level));
    EXPECT_EQ(parent_of(deep), node_at(direction, deepest_level - 1));
    EXPECT_EQ(node_at(middle_of(node_at(direction, 7)), 7), node_at(direction, 7));
  }
}

TEST(CubeGrid, QuartersANode) {
  Places places(2);
  for (const int level : {0, 1, 5, deepest_level - 1}) {
    const QuadNode node = some_node(places, level);
    for (const QuadNode& child : children_of(node)) {
      EXPECT_EQ(parent_of(child), node);
      EXPECT_EQ(node_at(middle_of(child), level + 1), child);
    }
  }
}

// So that nodes of different levels, and faces, have whole vertices in common.
TEST(CubeGrid, HasTheSameVerticesWhateverTheNode) {
  Places places(3);
  for (const int level : {1, 2, 8, 20, deepest_level}) {
    const QuadNode node = some_node(places, level), above = parent_of(node);
    const int first_i = node.x % 2 == 0 ? 0 : cells / 2, first_j = node.y % 2 == 0 ? 0 : cells / 2;
    for (int j = 0; j <= cells; j += 2) {
      for (int i = 0; i <= cells; i += 2)
        EXPECT_EQ(vertex_direction(node, i, j, cells),
                  vertex_direction(above, first_i + i / 2, first_j + j / 2, cells));
    }
  }
}

// The vertices of a side, from one end to the other.
std::vector<glm::dvec3> vertices_along(const QuadNode& node, Side side) {
  std::vector<glm::dvec3> vertices;
  for (int k = 0; k <= cells; ++k) {
    const bool along_y = side == Side::left || side == Side::right;
    const int out = side == Side::right || side == Side::top ? cells : 0;
    vertices.push_back(along_y ? vertex_direction(node, out, k, cells) : vertex_direction(node, k, out, cells));
  }
  return vertices;
}

TEST(CubeGrid, KnowsWhatLiesAcrossASide) {
  Places places(4);
  for (int n = 0; n < 600; ++n) {
    // On the first levels nearly every side is an edge of the cube.
    const QuadNode node = some_node(places, n % 30);
    for (const Side side : sides) {
      const QuadNode next = across(node, side);
      EXPECT_EQ(next.level, node.level);
      EXPECT_FALSE(next == node);
      const std::vector<glm::dvec3> here = vertices_along(node, side);
      const auto shares_them = [&](Side other) {
        std::vector<glm::dvec3> there = vertices_along(next, other);
        if (there.front() != here.front()) std::reverse(there.begin(), there.end());
        return there == here;
      };
      EXPECT_TRUE(std::any_of(sides.begin(), sides.end(), shares_them))
          << node.face << "/" << node.level << ": " << node.x << ", " << node.y;
    }
  }
}

TEST(CubeGrid, EdgeIsTheLongestSide) {
  for (const int level : {0, 1, 3, 6}) {
    double longest = 0.0, shortest = 10.0;
    const auto count = std::uint32_t{1} << level;
    for (std::uint32_t y = 0; y < count; ++y) {
      for (std::uint32_t x = 0; x < count; ++x) {
        const QuadNode node = {0, level, x, y};
        const glm::dvec3 a = vertex_direction(node, 0, 0, cells), b = vertex_direction(node, cells, 0, cells);
        const double edge = 2.0 * std::asin(0.5 * glm::distance(a, b));
        longest = std::max(longest, edge);
        shortest = std::min(shortest, edge);
      }
    }
    EXPECT_LE(longest, node_edge(level) * (1.0 + 1e-12));
    EXPECT_GT(longest, (level > 0 ? 0.98 : 0.7) * node_edge(level));
    EXPECT_GT(shortest, 0.7 * node_edge(level));
  }
}

}  // namespace
}  // namespace terrella
