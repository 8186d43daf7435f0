// What mountains hide: nodes of a ground that lie wholly behind nearer ones. Lengths in planet radii.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "planet/drawn_node.hpp"
#include "planet/node_cache.hpp"
#include "planet/node_sight.hpp"

namespace terrella {

// How a node looks from the eye: over which azimuths and how high.
struct NodeSilhouette {
  DrawnNode drawn;
  bool is_known = false;
  double nearest = 0.0;            // from below the eye, as a chord, here and below
  double from = 0.0, to = 0.0;     // azimuths of its corners
  double widened = 0.0;            // by how much its sides may reach beyond these
  double top = 0.0, bottom = 0.0;  // tangents of elevations
  double hidden_from = 0.0;        // from here on it hides all that is no higher than its bottom
};

// Those of a picture, and room to sort them.
struct NodeSilhouettes {
  std::vector<NodeSilhouette> all;
  // Distances and places of them: of all by their nearest, and of those that can hide by hidden_from.
  std::array<std::vector<std::pair<double, std::size_t>>, 2> orders;
};

// Leaves out of what would be drawn the nodes of which nothing can be seen over nearer ones, and sorts the others, the
// nearest first; of_all: of those that were to be drawn. Never leaves out what can be seen, for an eye over the ground:
// what hides are only heights that are drawn (NodeFrame::shown). Allocates nothing but for more nodes than ever before.
void leave_out_hidden(const NodeGrid& grid, const NodeSight& sight, int cells, const NodeCache& cache,
                      NodeSilhouettes& of_all, std::vector<DrawnNode>& drawn);

}  // namespace terrella
