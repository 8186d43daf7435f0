// The vertices of a node of a cube_grid and the triangles between them: computed in double precision and told from the
// node's middle, so that single precision suffices from there on. Lengths in planet radii.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "formulas/formulas.hpp"
#include "planet/cube_grid.hpp"
#include "planet/height_bounds.hpp"

namespace terrella {

// Of a node with so many cells along a side; row after row, x first.
constexpr int vertices_a_node(int cells) { return (cells + 1) * (cells + 1); }

// A vertex as its level of detail has it, and by how much that changes where the level gives way to the coarser one.
struct NodeVertices {
  std::vector<glm::vec4> place;    // xyz: from the node's centre; w: height over its base
  std::vector<glm::vec4> coarser;  // what is to be added to them
  std::vector<glm::vec4> slope;    // xyz: gradient of the height, along the sphere; w: openness
  std::vector<glm::vec4> coarser_slope;
  // xy: rise and ridges of Height, of the ground's whole height, so that half floats hold those of the lowest; zw: what
  // is to be added to them
  std::vector<glm::vec4> rise;
};

// A node's place in the world.
struct NodeFrame {
  glm::dvec3 middle{0.0};   // unit; the node's centre is this times 1 + base
  double base = 0.0;        // a height of its ground
  double half_width = 0.0;  // no vertex is further from the middle, on the unit sphere
  HeightRange heights;      // of all ground over the node, whatever the level of detail
};

// Heights are those that vertices of the node's level can carry; the coarser ones those of the level above, at every
// second vertex, and between these on the straight edges of its triangles: vertices that both levels have come out the
// same, but for rounding to single precision.
// cells: along a side, even, least_cells..most_cells.
NodeFrame make_node(const QuadNode& node, int cells, const f64::Terrain& terrain, NodeVertices& vertices);

// Beyond the vertices of a node its rim once more, for skirts: from the corner x = y = 0 along x first and around.
constexpr int vertices_a_rim(int cells) { return 4 * cells; }

// Three vertices a triangle, counter-clockwise from outside. coarser: a bit for each of `sides`, by number, where the
// neighbour is of the level above: every second vertex of that side is left out, so that each edge there is one of the
// neighbour's. skirt: whether a skirt hangs from the rim.
std::vector<std::uint16_t> node_triangles(int cells, unsigned coarser, bool skirt);

}  // namespace terrella
