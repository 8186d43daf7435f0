#include "measure/checks.hpp"

#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "formulas/formulas.hpp"

namespace terrella {
namespace {

// Distances are told in single precision, where the triangles of the coarsest mesh may just touch the sphere.
constexpr double slack = 1e-5;

}  // namespace

std::int64_t nonfinite_pixels(Pixels light) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i + 3 < light.size(); i += 4) {
    bool finite = true;
    for (std::size_t c = 0; c < 4; ++c) finite = finite && std::isfinite(light[i + c]);
    if (!finite) ++count;
  }
  return count;
}

Holes find_holes(Pixels distance, const Pose& pose, const View& view, double solid) {
  CHECK(distance.size() == 4 * static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height),
        distance.size(), " floats");
  Holes holes;
  const double edge = 0.01 * pose.pixel_angle * glm::length(pose.eye);
  const double radius = solid * (1.0 - slack) - edge;
  if (radius <= 0.0) return holes;
  std::size_t i = 0;
  for (int y = view.height - 1; y >= 0; --y) {
    for (int x = 0; x < view.width; ++x, i += 4) {
      const glm::dvec3 ray = ray_through(pose, view, {x + 0.5, y + 0.5});
      const double begins = f64::ray_sphere(pose.eye, ray, radius).t0;
      if (begins <= 0.0) continue;
      ++holes.looked_at;
      if (!(double{distance[i]} <= begins * (1.0 + slack))) ++holes.open;
    }
  }
  return holes;
}

}  // namespace terrella
