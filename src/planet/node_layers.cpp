#include "planet/node_layers.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "planet/mirror.hpp"
#include "planet/spheres.hpp"
#include "planet/terrain.hpp"

namespace terrella {

NodeRanges ranges_of(const NodeGrid& grid, const Needs& needs) {
  NodeRanges ranges = {std::max(needs.ground_split, least_split(grid.reach())), 0, needs.ground_cells, grid.reach()};
  while (ranges.deepest < deepest_level && grid.spacing(ranges.deepest, ranges.cells) > needs.ground_finest)
    ++ranges.deepest;
  return ranges;
}

NodeRanges sea_ranges_of(const NodeGrid& grid, const Needs& needs) {
  NodeRanges ranges = ranges_of(grid, needs);
  if (needs.water == Water::waves) ranges.split = least_split(grid.reach());
  return ranges;
}

NodeSight sight_of_nodes(const Scene& scene, const Needs& needs, const Pose& pose, const View& view) {
  const double sea = needs.water == Water::none ? 0.0 : water_radius(scene);
  // Under all of the ground and the water, and what they hide lies behind it.
  NodeSight sight = node_sight(pose, view, {0, view.height}, std::max(sea - needs.sea_swell, 1.0));
  // From under water it is seen against what lies over it.
  sight.mountains_hide = !needs.in_water;
  if (needs.water_sight > 0.0) sight.farthest = needs.water_sight;
  sight.sea = sea;
  if (sea > 0.0) {
    sight.sea_lift = needs.water_lift;
    sight.sea_swell = needs.sea_swell;
    sight.sea_hides = needs.water_hides;
    sight.most_sea_lift = needs.water_most_lift;
  }
  if (needs.mirrored_land > 0.0) {
    const Mirror mirror = mirror_of(scene, pose, view);
    const auto sides = node_sight(mirror.pose, mirror.view, {0, mirror.view.height}, 0.0).sides;
    sight.mirror = {mirrored_eye(mirror), sides, mirror.height, mirror.pose.pixel_angle};
  }
  return sight;
}

NodeDetails details_of(const Scene& scene, const NodeGrid& grid, int cells) {
  NodeDetails details;
  for (int level = 0; level <= deepest_level; ++level) {
    const double spacing = grid.spacing(level, cells);
    details.at(static_cast<std::size_t>(level)) = {spacing, unseen_heights(scene, spacing, 0.0)};
  }
  return details;
}

namespace {

// The highest of its ground that a picture shows, unless a hill stands there that is one of ten thousand.
double highest_shown(const NodeFrame& node, const NodeDetail& detail) {
  constexpr double deviations = 4.0;
  return 1.0 + std::min(node.shown.highest + deviations * detail.unseen, node.heights.highest);
}

// Nothing of its ground is seen.
bool is_deep(const NodeFrame& node, const NodeDetail& detail, const NodeSight& sight) {
  return !node.may_freeze && highest_shown(node, detail) < sight.sea - sight.sea_hides;
}

}  // namespace

bool shows(NodeLayer layer, const NodeFrame& node, const NodeDetail& detail, const NodeSight& sight) {
  if (layer == NodeLayer::mirrored) return is_in_mirror(sight, node, highest_shown(node, detail));
  // Else all that was chosen is in it.
  if (sight.mirror && !is_in_picture(sight, node, 0.0)) return false;
  const bool water = sight.sea > 0.0;
  if (layer == NodeLayer::ground) {
    const double lowest_sea = sight.sea * (1.0 - detail.spacing * detail.spacing / 8.0);
    if (!water) return true;
    const bool may_dive = glm::length(sight.eye) <= sight.sea + sight.sea_swell;
    return (may_dive || 1.0 + node.heights.highest >= lowest_sea) && !is_deep(node, detail, sight);
  }
  if (!water) return false;
  if (layer == NodeLayer::deep_sea) return is_deep(node, detail, sight);
  // By what is drawn: sea has the same vertices, only on its sphere.
  return !is_deep(node, detail, sight) && 1.0 + node.shown.lowest <= sight.top_of_sea(node.outline);
}

double mirrored_climb(const NodeFrame& node, const NodeDetail& detail, const NodeSight& sight) {
  const double climb = highest_shown(node, detail) - sight.sea + sight.mirror->height;
  return climb / std::hypot(climb, nearest_to(node.outline, glm::normalize(sight.eye)));
}

unsigned list_of(const NodePatch& patch, const DrawnNode& drawn, NodeLayer layer) {
  return layer == NodeLayer::deep_sea ? patch.list_of_every_second() : list_of(patch, drawn);
}

}  // namespace terrella
