// Grids whose nodes are squares of faces.
#pragma once

#include <optional>

#include "planet/node_grid.hpp"

namespace terrella {

enum class Side { left, right, bottom, top };  // where x is least, x is most, y is least, y is most
inline constexpr std::array<Side, 4> square_sides = {Side::left, Side::right, Side::bottom, Side::top};

class SquareGrid : public NodeGrid {
 public:
  [[nodiscard]] std::array<GridNode, 4> children_of(const GridNode& node) const override;
  [[nodiscard]] GridNode parent_of(const GridNode& node) const override;
  [[nodiscard]] NodesAround around(const GridNode& node) const override;
  [[nodiscard]] NodePatch patch(int cells) const override { return square_patch(cells); }
  [[nodiscard]] glm::dvec3 vertex_direction(const GridNode& node, int i, int j, int cells) const override;
  [[nodiscard]] glm::dvec3 middle_of(const GridNode& node) const override { return vertex_direction(node, 1, 1, 2); }

  // The node of the same level across a side, or nothing where there is none.
  [[nodiscard]] std::optional<GridNode> across(const GridNode& node, Side side) const;

 protected:
  // Unit vector to a place of a face, -1..1 from the middle of its sides.
  [[nodiscard]] virtual glm::dvec3 direction_on(int face, double x, double y) const = 0;
  // What lies across a side that is one of the face.
  [[nodiscard]] virtual std::optional<GridNode> beyond_face(const GridNode& node, Side side) const = 0;

 private:
  // The node that has only a corner in common, numbered as square_patch numbers them.
  [[nodiscard]] std::optional<GridNode> beyond_corner(const GridNode& node, unsigned corner) const;
};

// How far the cell or vertex of a number is from the middle of a side of a face, -1..1. The same bits however fine the
// nodes are that it is told from, and but for the sign from whichever end the side is counted.
double place_of_number(double number, int level, int cells);

}  // namespace terrella
