#include "planet/node_layers.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "planet/spheres.hpp"

namespace terrella {

NodeRanges ranges_of(const Needs& needs) { return {needs.ground_split, needs.ground_deepest, needs.ground_cells}; }

NodeSight sight_of_nodes(const Scene& scene, const Needs& needs, const Pose& pose, const View& view) {
  const double sea = needs.water == Water::none ? 0.0 : water_radius(scene);
  // Under all of the ground and the water, and what they hide lies behind it.
  NodeSight sight = node_sight(pose, view, {0, view.height}, std::max(sea, 1.0));
  sight.sea = sea;
  return sight;
}

bool shows(NodeLayer layer, const NodeCache::Entry& entry, const Scene& scene, const Needs& needs, const Pose& pose) {
  const bool water = needs.water != Water::none;
  const NodeFrame& node = entry.frame;
  const double sea = water_radius(scene), spacing = vertex_spacing(entry.node.level, needs.ground_cells);
  if (layer == NodeLayer::ground) {
    const double lowest_sea = sea * (1.0 - spacing * spacing / 8.0);
    return !water || glm::length(pose.eye) <= sea || 1.0 + node.heights.highest >= lowest_sea;
  }
  const double away = glm::distance(pose.eye, node.middle) + node.half_width;
  return water && 1.0 + node.heights.lowest <= sea + std::min(needs.water_lift * away, needs.water_most_lift);
}

}  // namespace terrella
