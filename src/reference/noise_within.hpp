// Between which values noise lies near a place where it is known.
#pragma once

#include <algorithm>

#include <glm/geometric.hpp>

#include "formulas/formulas.hpp"
#include "planet/noise_bounds.hpp"
#include "reference/range.hpp"

namespace terrella::reference {

// Bounds of the noise within a distance (cells, >= 0) of the place of the given one.
inline Range noise_within(const f64::Noise& middle, double cells) {
  const double slope = std::min(noise_slope, glm::length(middle.gradient) + 0.5 * noise_curvature * cells);
  return {middle.value - slope * cells, middle.value + slope * cells};
}

}  // namespace terrella::reference
