// The vertices of a node and the triangles between them, which all nodes of a grid have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace terrella {

// What a vertex lies on and what neighbours share, as bits: sides from the first bit on, and corners.
inline constexpr unsigned first_side = 1, first_corner = 16;
inline constexpr unsigned all_sides = first_corner - 1;

// Lists of triangles that a patch has at the most.
inline constexpr std::size_t most_node_lists = 17;

struct NodePatch {
  struct Vertex {
    int i = 0, j = 0;                // as NodeGrid::vertex_direction has them
    std::uint16_t from = 0, to = 0;  // the vertices of the level above half way between which it lies; itself, twice,
                                     // where it is one of those
    unsigned touches = 0;            // sides and corners that it lies on
  };

  int cells = 0;       // along a side
  unsigned sides = 0;  // 3 or 4
  std::vector<Vertex> vertices;
  std::vector<std::uint16_t> triangles;  // three vertices each, counter-clockwise from outside
  std::vector<std::uint16_t> rim;        // vertices around it, clockwise from outside, each side's after one another

  // Lists of triangles: one for each set of sides that can have coarser neighbours, and one of every second vertex.
  [[nodiscard]] unsigned lists() const { return (1U << sides) + 1; }
  [[nodiscard]] unsigned list_of_every_second() const { return 1U << sides; }
  // A patch's vertices and, beyond them, those of its rim once more, for skirts.
  [[nodiscard]] std::size_t vertices_with_rim() const { return vertices.size() + rim.size(); }
};

// Vertices of a patch that has so many sides, and cells along each.
constexpr int vertices_of_patch(unsigned sides, int cells) {
  return sides == 3 ? (cells + 1) * (cells + 2) / 2 : (cells + 1) * (cells + 1);
}

// Nodes that are kept at a time, of so many vertices each: as many as take no more memory than 2,048 of the largest
// patch, and at the most 4,096. A picture draws a hundred to a thousand; the rest is what it would draw from other
// places.
int node_room(int vertices);

// Of squares: i along x, j along y, which turn clockwise from outside; sides left, right, bottom, top; corners where
// both are least, x is most, y is most, both are. cells: even, > 0.
NodePatch square_patch(int cells);

// Of triangles: from corner 0 on i towards 1 and j towards 2, i + j <= cells, which turn counter-clockwise from
// outside; each side is opposite the corner of its number. cells: even, > 0.
NodePatch triangle_patch(int cells);

// Three vertices a triangle. list: the sides where the neighbour is of the level above: every second vertex there is
// left out, so that each edge is one of the neighbour's; or list_of_every_second, which leaves them out all over, so
// that the triangles are those of the level above. skirt: whether a skirt hangs from the rim.
std::vector<std::uint16_t> node_triangles(const NodePatch& patch, unsigned list, bool skirt);

}  // namespace terrella
