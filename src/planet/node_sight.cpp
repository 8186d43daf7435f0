#include "planet/node_sight.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace terrella {

double NodeSight::top_of_sea(const NodeOutline& node) const {
  return sea + sea_swell + std::min(sea_lift * (glm::distance(eye, node.middle) + node.half_width), most_sea_lift);
}

NodeSight node_sight(const Pose& pose, const View& view, const Rows& rows, double occluder) {
  const double w = view.width, top = view.height - rows.end, bottom = view.height - rows.first;
  const std::array<glm::dvec2, 4> corners = {{{0.0, top}, {0.0, bottom}, {w, bottom}, {w, top}}};
  NodeSight sight = {pose.eye, {}, occluder};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 from = ray_through(pose, view, corners.at(i));
    const glm::dvec3 to = ray_through(pose, view, corners.at((i + 1) % 4));
    sight.sides.at(i) = glm::normalize(glm::cross(to, from));
  }
  return sight;
}

}  // namespace terrella
