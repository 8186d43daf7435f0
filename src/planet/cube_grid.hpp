// A sphere as a cube whose six faces are quadtrees (Andrei, section 2): nodes, and the grid of vertices of each. The
// places on a face are spread by tangents, so that nodes of a level differ little in size.
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace terrella {

// Cells along a side of a node, at the most; its vertices are one more (Andrei, section 2). An even number, so that a
// node's parent has every second of its vertices.
inline constexpr int most_cells = 28, least_cells = 8;

// Nodes this small are 30 cm wide on a planet of 1e8 m, their cells 1 cm.
inline constexpr int deepest_level = 29;

// A square of a face of the cube, numbered as OpenGL numbers faces (cube_face_direction).
struct QuadNode {
  int face = 0;                // 0..5
  int level = 0;               // 0..deepest_level
  std::uint32_t x = 0, y = 0;  // 0..2^level - 1, from the corner at place -1, -1
  bool operator==(const QuadNode&) const = default;
};

// Its four quarters. node: of a level below deepest_level.
std::array<QuadNode, 4> children_of(const QuadNode& node);

// Of a node of level 1 or more.
QuadNode parent_of(const QuadNode& node);

// Unit vector to a vertex. i, j: 0..cells along x and y. The same bits for every node that has the vertex, whatever its
// level, on machines that do not fuse products and sums.
glm::dvec3 vertex_direction(const QuadNode& node, int i, int j, int cells);

// Unit vector to the middle.
glm::dvec3 middle_of(const QuadNode& node);

// How long the longest side of a node of a level is, rad.
double node_edge(int level);

// Distance of the vertices of a level, at the most, rad.
inline double vertex_spacing(int level, int cells) { return node_edge(level) / cells; }

// The node of a level that a direction (not 0) passes through.
QuadNode node_at(const glm::dvec3& direction, int level);

enum class Side { left, right, bottom, top };  // where x is least, x is most, y is least, y is most
inline constexpr std::array<Side, 4> sides = {Side::left, Side::right, Side::bottom, Side::top};

// The node of the same level across a side.
QuadNode across(const QuadNode& node, Side side);

}  // namespace terrella
