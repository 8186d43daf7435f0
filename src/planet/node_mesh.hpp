// The vertices of a node: computed in double precision and told from the node's middle, so that single precision
// suffices from there on. Lengths in planet radii.
#pragma once

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "formulas/formulas.hpp"
#include "planet/height_bounds.hpp"
#include "planet/node_outline.hpp"

namespace terrella {

// Vertices of a patch as their level of detail has them, and by how much that changes where the level gives way to the
// coarser one.
struct NodeVertices {
  // xyz: from the node's centre; w: height over the ground that pixels go on with, which on ice is the ice
  std::vector<glm::vec4> place;
  std::vector<glm::vec4> coarser;  // what is to be added to them
  // Of what pixels go on with, which is the ground that samples held_footprint apart show. xyz:
  // gradient of the height, along the sphere, none on ice; w: relief of Height
  std::vector<glm::vec4> slope;
  std::vector<glm::vec4> coarser_slope;
  std::vector<glm::vec4> shape_slope;  // xyz: what of the gradient comes of the shape of Height
  std::vector<glm::vec4> coarser_shape_slope;
  // xy: mean and shape of Height, to which ice_flag is added where ice lies, and half of it midway between ice and
  // none; zw: what is to be added to them
  std::vector<glm::vec4> means;
};

// More than twice what shapes are.
inline constexpr double ice_flag = 8.0;

// A node's place in the world.
struct NodeFrame {
  NodeOutline outline;
  double base = 0.0;        // a height of its ground; the node's centre is the middle times 1 + base
  HeightRange heights;      // of all ground over the node, whatever the level of detail
  HeightRange shown;        // of its vertices, as its level has them and as the level above has
  NodesAround around;       // as its grid has them
  bool may_freeze = false;  // whether ice may lie on it
};

// Heights are those that vertices of the node's level can carry; the coarser ones those of the level above, at every
// second vertex, and between these on the straight edges of its triangles: vertices that both levels have come out the
// same, but for rounding to single precision.
// patch: of the grid.
NodeFrame make_node(const NodeGrid& grid, const NodePatch& patch, const GridNode& node, const f64::Terrain& terrain,
                    NodeVertices& vertices);

}  // namespace terrella
