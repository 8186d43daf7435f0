#include "planet/node_layers.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "planet/spheres.hpp"

namespace terrella {

NodeRanges ranges_of(const NodeGrid& grid, const Needs& needs) {
  NodeRanges ranges = {std::max(needs.ground_split, least_split(grid.reach())), 0, needs.ground_cells, grid.reach()};
  while (ranges.deepest < deepest_level && grid.spacing(ranges.deepest, ranges.cells) > needs.ground_finest)
    ++ranges.deepest;
  return ranges;
}

NodeSight sight_of_nodes(const Scene& scene, const Needs& needs, const Pose& pose, const View& view) {
  const double sea = needs.water == Water::none ? 0.0 : water_radius(scene);
  // Under all of the ground and the water, and what they hide lies behind it.
  NodeSight sight = node_sight(pose, view, {0, view.height}, std::max(sea - needs.sea_swell, 1.0));
  sight.mountains_hide = true;
  sight.sea = sea;
  if (sea > 0.0) {
    sight.sea_lift = needs.water_lift;
    sight.sea_swell = needs.sea_swell;
    sight.most_sea_lift = needs.water_most_lift;
  }
  return sight;
}

bool shows(NodeLayer layer, const NodeFrame& node, double spacing, const NodeSight& sight) {
  const bool water = sight.sea > 0.0;
  if (layer == NodeLayer::ground) {
    const double lowest_sea = sight.sea * (1.0 - spacing * spacing / 8.0);
    return !water || glm::length(sight.eye) <= sight.sea + sight.sea_swell || 1.0 + node.heights.highest >= lowest_sea;
  }
  // By what is drawn: sea has the same vertices, only on its sphere.
  return water && 1.0 + node.shown.lowest <= sight.top_of_sea(node.outline);
}

}  // namespace terrella
