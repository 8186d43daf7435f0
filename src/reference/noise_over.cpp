#include "reference/noise_over.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "planet/noise_bounds.hpp"

namespace terrella::reference {
namespace {

// Cells to the furthest of the directions from where the noise is known.
double reach_of(const Directions& directions, const KnownNoise& known, double frequency) {
  return frequency * (glm::distance(directions.middle, known.direction) + directions.chord);
}

// How far a slope (per radian) lifts any of the directions over their middle.
double lift_of(const Directions& directions, const glm::dvec3& slope) {
  const double chord = directions.chord;
  if (!directions.along) return glm::length(slope) * chord;
  // On a great circle they lie aside by at most the chord, and lower by half of its square.
  return std::abs(glm::dot(slope, *directions.along)) * chord +
         0.5 * std::abs(glm::dot(slope, directions.middle)) * chord * chord;
}

}  // namespace

Range noise_over(const Directions& directions, const KnownNoise& known, double frequency) {
  const glm::dvec3 slope = frequency * known.noise.gradient;
  const double reach = reach_of(directions, known, frequency);
  const double value = known.noise.value + glm::dot(slope, directions.middle - known.direction);
  const double bend = 0.5 * noise_curvature * reach * reach;
  const double rise = lift_of(directions, slope) + bend;
  // No slope is steeper than noise_slope, whichever way the bound is told.
  const double steepest = noise_slope * reach;
  return {std::max(value - rise, known.noise.value - steepest), std::min(value + rise, known.noise.value + steepest)};
}

bool NoiseMemory::tells_of(const Directions& directions, int layer, double frequency) const {
  const std::optional<KnownNoise>& known = layers_[static_cast<std::size_t>(layer)];
  if (!known) return false;
  // As a part of how far slopes as they are in the mean lift the layer within the chord.
  constexpr double looser = 1.0;
  const double reach = reach_of(directions, *known, frequency);
  return 0.5 * noise_curvature * reach * reach <= looser * frequency * directions.chord;
}

}  // namespace terrella::reference
