// Sets of directions from the planet's centre, over which bounds hold.
#pragma once

#include <optional>

#include <glm/vec3.hpp>

namespace terrella::reference {

// Directions (unit) within a chord of one; where `along` is told, only those on the great circle that leaves it that
// way, which is where the places of a ray lie.
struct Directions {
  glm::dvec3 middle;  // unit
  double chord;
  std::optional<glm::dvec3> along = std::nullopt;  // unit, at a right angle to the middle
};

}  // namespace terrella::reference
