// Evenly spaced directions, without a pole or a seam.
#pragma once

#include <cmath>
#include <numbers>

#include <glm/vec3.hpp>

namespace terrella {

// Direction i (unit) of count along a spiral from the north pole to the south pole. i: 0..count - 1.
inline glm::dvec3 spiral_direction(int i, int count) {
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  const double z = 1.0 - (2.0 * i + 1.0) / count;
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(golden * i), r * std::sin(golden * i), z};
}

}  // namespace terrella
