// Which nodes of a cube_grid are drawn for an eye (Andrei, section 2): the finer, the nearer, and no two levels side by
// side that are not neighbours. Lengths in planet radii.
#pragma once

#include <array>
#include <vector>

#include "planet/node_cache.hpp"
#include "planet/node_ranges.hpp"

namespace terrella {

// What can be seen of a ground.
struct NodeSight {
  glm::dvec3 eye;
  std::array<glm::dvec3, 4> sides;  // unit, inwards, of the planes through the eye
  double occluder;                  // radius of a sphere that hides what lies behind it
  double sea = 0.0;                 // radius up to which a sea lies over lower ground; 0: there is none
};

// rows: of the picture.
NodeSight node_sight(const Pose& pose, const View& view, const Rows& rows, double occluder);

struct DrawnNode {
  int slot;
  unsigned coarser;  // bits 0..3: the node across that one of `sides` is of the level above;
                     // bits 4..7: one across a corner, that where x and y are least, x is most, y is most, both are
};

struct MissingNode {
  QuadNode node;
  double distance;  // of the node that it is a quarter of
};

// Room for a frame's work, so that none is allocated again.
struct NodeChoice {
  std::vector<DrawnNode> drawn;
  std::vector<MissingNode> missing;  // what the picture lacks to be as fine as it should be; the coarsest first, and
                                     // of a level the nearest

  std::vector<int> level, next;  // slots of nodes of a level while it is looked through
};

// All nodes of a sphere undivided. They must be in the cache before any are chosen.
std::array<QuadNode, 6> root_nodes();

// Replaces what was chosen before. The cache must have begun the frame.
void choose_nodes(const NodeSight& sight, const NodeEye& eye, const NodeRanges& ranges, NodeCache& cache,
                  NodeChoice& choice);

// How far, at least, a node's ground is from the eye, as NodeEye counts.
double distance_of(const NodeFrame& node, const NodeEye& eye);

}  // namespace terrella
