#include "planet/node_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace terrella {

double lift_over(double nearest) { return nearest * std::sqrt(1.0 + 3.0 / (1.0 + 50.0 * nearest)); }

NodeEye eye_over(const f64::Terrain& terrain, const Pose& pose) {
  constexpr int rings = 8, spokes = 8;
  const double distance = glm::length(pose.eye);
  const glm::dvec3 up = pose.eye / distance;
  const glm::dvec3 u = f64::perpendicular(up), v = glm::cross(up, u);
  // Nothing further aside than the ground below can be nearer.
  const double reach = std::min(pose.clearance, 0.5 * std::numbers::pi);
  double nearest = pose.nearest;
  for (int ring = 1; ring <= rings; ++ring) {
    const double angle = reach * ring / rings;
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const double turn = 2.0 * std::numbers::pi * (spoke + 0.5 * (ring % 2)) / spokes;
      const glm::dvec3 place = std::cos(angle) * up + std::sin(angle) * (std::cos(turn) * u + std::sin(turn) * v);
      const double height = f64::terrain_height_at(place, terrain, reach / rings).value;
      // As far as the eye is above, and as far as the place lies aside: without the difference of large numbers.
      const double above = distance - 1.0 - height, half = std::sin(0.5 * angle);
      nearest = std::min(nearest, std::sqrt(above * above + 4.0 * distance * (1.0 + height) * half * half));
    }
  }
  // From afar a chord is seen under a greater angle than its distance tells, by the root of this.
  return {up, lift_over(nearest) / std::sqrt(std::max(distance, 1.0))};
}

}  // namespace terrella
