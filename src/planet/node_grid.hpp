// How a ground is divided into nodes that are split in four where it is to be finer, and where their vertices lie: what
// the methods that draw a planet of real size differ in.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "planet/node_patch.hpp"

namespace terrella {

// Cells along a side of a node, at the most and at the least. An even number, so that a node's parent has every second
// of its vertices (Andrei, section 2, has 28).
inline constexpr int most_cells = 28, least_cells = 8;

// Nodes this small are 30 cm wide on a planet of 1e8 m, their cells 1 cm.
inline constexpr int deepest_level = 29;

// A node of a grid: faces are numbered as the grid has them, and so are the places on a face.
struct GridNode {
  int face = 0;                // 0..31
  int level = 0;               // 0..deepest_level
  std::uint32_t x = 0, y = 0;  // 0..2^level - 1
  bool operator==(const GridNode&) const = default;
};

// A node of the same level that has vertices in common with another, and the bit for what it shares (NodePatch).
struct NodeBeside {
  GridNode node;
  unsigned shares;
};

// All of those around a node.
class NodesAround {
 public:
  void add(const GridNode& node, unsigned shares) { list_.at(count_++) = {node, shares}; }
  [[nodiscard]] const NodeBeside* begin() const { return list_.data(); }
  [[nodiscard]] const NodeBeside* end() const { return list_.data() + count_; }

 private:
  std::array<NodeBeside, 12> list_{};
  std::size_t count_ = 0;
};

class NodeGrid {
 public:
  virtual ~NodeGrid() = default;

  // All of its nodes undivided.
  [[nodiscard]] virtual std::span<const GridNode> roots() const = 0;
  // A node's four quarters. node: of a level below deepest_level.
  [[nodiscard]] virtual std::array<GridNode, 4> children_of(const GridNode& node) const = 0;
  // Of a node of level 1 or more.
  [[nodiscard]] virtual GridNode parent_of(const GridNode& node) const = 0;
  [[nodiscard]] virtual NodesAround around(const GridNode& node) const = 0;

  // Vertices and triangles of every node. cells: even, least_cells..most_cells.
  [[nodiscard]] virtual NodePatch patch(int cells) const = 0;
  // Unit vector to a vertex. i, j: as a patch of so many cells has them. The same bits for every node that has the
  // vertex, whatever its level, on machines that do not fuse products and sums.
  [[nodiscard]] virtual glm::dvec3 vertex_direction(const GridNode& node, int i, int j, int cells) const = 0;
  // Unit vector to the middle.
  [[nodiscard]] virtual glm::dvec3 middle_of(const GridNode& node) const = 0;

  // How long the longest side of a node of a level is, rad.
  [[nodiscard]] virtual double edge(int level) const = 0;
  // How far apart two places of a node are, of its level's longest side: few nodes have more.
  [[nodiscard]] virtual double reach() const = 0;

  // Distance of the vertices of a level along the sides of cells, at the most, rad.
  [[nodiscard]] double spacing(int level, int cells) const { return edge(level) / cells; }
};

}  // namespace terrella
