// Which grid a ground of nodes is divided by.
#pragma once

#include <memory>

#include "planet/needs.hpp"
#include "planet/node_grid.hpp"

namespace terrella {

// technique: of nodes. scene, pose: what a grid around the eye is made for; the others do not depend on them.
std::shared_ptr<const NodeGrid> grid_of(Ground technique, const Scene& scene, const Pose& pose);

// What every node of such a grid has, wherever it is.
NodePatch patch_of(Ground technique, int cells);

}  // namespace terrella
