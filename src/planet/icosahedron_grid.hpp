// A sphere as an icosahedron whose twenty triangles are split in four again and again (Lindner). Two triangles of the
// icosahedron make a rhombus, of which a node is a half cell: face 2 r is the lower half of rhombus r, where x + y is
// least, and 2 r + 1 the upper one; as well in its cells.
#pragma once

#include "planet/node_grid.hpp"

namespace terrella {

class IcosahedronGrid : public NodeGrid {
 public:
  [[nodiscard]] std::span<const GridNode> roots() const override;
  [[nodiscard]] std::array<GridNode, 4> children_of(const GridNode& node) const override;
  [[nodiscard]] GridNode parent_of(const GridNode& node) const override;
  [[nodiscard]] NodesAround around(const GridNode& node) const override;
  [[nodiscard]] NodePatch patch(int cells) const override { return triangle_patch(cells); }
  [[nodiscard]] glm::dvec3 vertex_direction(const GridNode& node, int i, int j, int cells) const override;
  [[nodiscard]] glm::dvec3 middle_of(const GridNode& node) const override { return vertex_direction(node, 1, 1, 3); }
  [[nodiscard]] double edge(int level) const override;
  [[nodiscard]] double reach() const override { return 1.0; }

  // The node across the side opposite a corner (0..2), and which of its sides that is.
  struct Across {
    GridNode node;
    unsigned side;
  };
  [[nodiscard]] static Across across(const GridNode& node, unsigned side);
};

}  // namespace terrella
