// Which nodes of a grid are drawn for an eye (Andrei, section 2): the finer, the nearer, and no two levels side by side
// that are not neighbours. Lengths in planet radii.
#pragma once

#include <vector>

#include "planet/drawn_node.hpp"
#include "planet/node_cache.hpp"
#include "planet/node_horizon.hpp"
#include "planet/node_ranges.hpp"
#include "planet/node_sight.hpp"

namespace terrella {

struct MissingNode {
  GridNode node;
  double distance;  // of the node that it is a quarter of
  bool is_ahead;    // not needed yet
};

// Room for a frame's work, so that none is allocated again.
struct NodeChoice {
  std::vector<DrawnNode> drawn;
  // What the picture lacks to be as fine as it should be; where it lacks nothing, what it will soon need, nearer or
  // turned aside. The coarsest first, and of a level the nearest.
  std::vector<MissingNode> missing;
  bool lacks = false;

  std::vector<int> level, next;  // slots of nodes of a level while it is looked through
  std::vector<int> around;       // and of those around the picture
  NodeSilhouettes silhouettes;
};

// Replaces what was chosen before. The cache must hold the roots of the grid, and have begun the frame.
void choose_nodes(const NodeGrid& grid, const NodeSight& sight, const NodeEye& eye, const NodeRanges& ranges,
                  NodeCache& cache, NodeChoice& choice);

// Whether a node is in the picture, or so far (rad) beside it.
bool is_in_picture(const NodeSight& sight, const NodeFrame& node, double aside);
// Whether any of it stands in the mirror of the sea, at least a pixel high. highest: radius that it reaches.
bool is_in_mirror(const NodeSight& sight, const NodeFrame& node, double highest);

// How far a node is from the eye, as NodeEye counts.
struct NodeDistance {
  double nearest;   // its nearest place
  double to_split;  // what is held against the distance within which it is split: the same, but where its farthest
                    // place would be left further than `widest` beyond that
};

// widest: NodeGrid::reach, as a distance.
NodeDistance distance_of(const NodeOutline& node, const NodeEye& eye, double widest);

}  // namespace terrella
