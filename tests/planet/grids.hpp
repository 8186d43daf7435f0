// The grids that grounds of nodes are divided by, for tests that hold for each.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <tuple>

#include <glm/geometric.hpp>

#include "laws/random_places.hpp"
#include "planet/cube_grid.hpp"
#include "planet/icosahedron_grid.hpp"
#include "planet/persistent_grid.hpp"

namespace terrella::test {

enum class Grid { cube, icosahedron, persistent };

inline std::ostream& operator<<(std::ostream& out, Grid grid) {
  return out << (grid == Grid::cube ? "Cube" : grid == Grid::icosahedron ? "Icosahedron" : "Persistent");
}

inline const auto all_grids = testing::Values(Grid::cube, Grid::icosahedron, Grid::persistent);

inline bool covers_sphere(Grid grid) { return grid != Grid::persistent; }

// For an eye and the highest terrain, which only one of them depends on.
inline std::shared_ptr<const NodeGrid> grid_for(Grid grid, const glm::dvec3& eye = {0.3, -1.2, 0.7},
                                                double top = 1e-3) {
  switch (grid) {
    case Grid::cube: return std::make_shared<CubeGrid>();
    case Grid::icosahedron: return std::make_shared<IcosahedronGrid>();
    case Grid::persistent: return std::make_shared<PersistentGrid>(eye, top);
  }
  return nullptr;
}

inline GridNode random_node(const NodeGrid& grid, Places& places, int level) {
  const std::span<const GridNode> roots = grid.roots();
  const auto some = [&](std::size_t count) {
    return std::min(static_cast<std::size_t>(places.between(0.0, static_cast<double>(count))), count - 1);
  };
  GridNode node = roots[some(roots.size())];
  while (node.level < level) node = grid.children_of(node).at(some(4));
  return node;
}

// An order of directions, so that they can be kept in sets and maps.
struct LessDirection {
  bool operator()(const glm::dvec3& a, const glm::dvec3& b) const {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }
};

// Of a patch's vertices, in their order.
inline std::vector<glm::dvec3> directions_of(const NodeGrid& grid, const NodePatch& patch, const GridNode& node) {
  std::vector<glm::dvec3> directions;
  for (const NodePatch::Vertex& vertex : patch.vertices)
    directions.push_back(grid.vertex_direction(node, vertex.i, vertex.j, patch.cells));
  return directions;
}

}  // namespace terrella::test
