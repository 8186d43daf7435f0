// What a picture shows of a ground of nodes, and what of that as ground and as sea. Lengths in planet radii.
#pragma once

#include "planet/needs.hpp"
#include "planet/node_choice.hpp"

namespace terrella {

// What is drawn of a node.
enum class NodeLayer { ground, sea };

// needs: of a ground of nodes, here and below.
NodeRanges ranges_of(const NodeGrid& grid, const Needs& needs);

// What all of the picture can see of ground and sea.
NodeSight sight_of_nodes(const Scene& scene, const Needs& needs, const Pose& pose, const View& view);

// Whether a node has anything to show of a layer: ground that rises from the sea, or sea over its ground.
// spacing: of its vertices (NodeGrid::spacing). sight: as of sight_of_nodes.
bool shows(NodeLayer layer, const NodeFrame& node, double spacing, const NodeSight& sight);

}  // namespace terrella
