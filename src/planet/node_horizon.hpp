// What mountains hide: nodes of a ground that lie wholly behind nearer ones. Lengths in planet radii.
#pragma once

#include "planet/node_choice.hpp"

namespace terrella {

// Leaves out of what was chosen the nodes of which nothing can be seen over nearer ones, and sorts the others, the
// nearest first. Never leaves out what can be seen, for an eye over the ground: what hides are only heights that are
// drawn (NodeFrame::shown). Allocates nothing but for more nodes than ever before.
void leave_out_hidden(const NodeGrid& grid, const NodeSight& sight, int cells, const NodeCache& cache,
                      NodeChoice& choice);

}  // namespace terrella
