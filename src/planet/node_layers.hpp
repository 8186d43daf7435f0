// What a picture shows of a ground of nodes, and what of that as ground and as sea. Lengths in planet radii.
#pragma once

#include <array>

#include "planet/needs.hpp"
#include "planet/node_choice.hpp"

namespace terrella {

// What is drawn of a node.
//
// deep_sea: of whose ground nothing is seen; all other sea is `sea`. mirrored: its land in the mirror of the sea.
enum class NodeLayer { ground, sea, deep_sea, mirrored };
inline constexpr std::size_t node_layers = 4;
constexpr bool is_sea(NodeLayer layer) { return layer == NodeLayer::sea || layer == NodeLayer::deep_sea; }

// needs: of a ground of nodes, here and below.
NodeRanges ranges_of(const NodeGrid& grid, const Needs& needs);
// Of its sea. With waves, each pixel of which costs the more, the smaller triangles are, no finer than nodes can be
// that pass from level to level.
NodeRanges sea_ranges_of(const NodeGrid& grid, const Needs& needs);

// What all of the picture can see of ground and sea.
NodeSight sight_of_nodes(const Scene& scene, const Needs& needs, const Pose& pose, const View& view);

// What the vertices of a level of detail know of the ground.
struct NodeDetail {
  double spacing = 0.0;  // of vertices, rad (NodeGrid::spacing)
  double unseen = 0.0;   // deviation of the heights that they don't tell (unseen_heights)
};
using NodeDetails = std::array<NodeDetail, deepest_level + 1>;
NodeDetails details_of(const Scene& scene, const NodeGrid& grid, int cells);

// Whether a node has anything to show of a layer: ground that rises from the sea, or sea over its ground. detail: of
// its level. sight: as of sight_of_nodes.
bool shows(NodeLayer layer, const NodeFrame& node, const NodeDetail& detail, const NodeSight& sight);

// How steeply, at the most, an eye as far below the sea as the true one is above looks up to a node: the sine. sight:
// of a sea that mirrors land.
double mirrored_climb(const NodeFrame& node, const NodeDetail& detail, const NodeSight& sight);

// The list of triangles that a node's layer is drawn with. Deep sea has every second vertex: it has no ground to carry.
unsigned list_of(const NodePatch& patch, const DrawnNode& drawn, NodeLayer layer);

}  // namespace terrella
