#include "passes/layers.hpp"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "formulas/formulas.hpp"

namespace terrella {
namespace {

// Beyond this frequency (cells per radian) integers of 32 bits no longer tell the cells apart; no picture shows them.
constexpr double highest_frequency = 1e9;

}  // namespace

LayerBlock layer_block(const Scene& scene, const Pose& pose, int first) {
  LayerBlock block{};
  const glm::dvec3 anchor = glm::normalize(pose.eye);
  const auto& terrain = scene.terrain;
  const double part = std::pow(terrain.persistence, first) / f64::amplitude_sum(terrain.persistence, terrain.octaves);
  block.anchor = glm::vec4(glm::dvec4(anchor, part));
  const auto seed = static_cast<unsigned>(scene.planet.seed);
  double frequency = terrain.frequency;
  for (int i = 0; i < terrain.octaves; ++i) {
    const double f = std::fmin(frequency, highest_frequency);
    const glm::dvec3 q = anchor * f + glm::dvec3(f64::layer_offset(i, seed));
    // The corner of the skewed lattice next to q, and what is left from there (simplex_of does the same).
    const glm::dvec3 cell = glm::floor(q + (q.x + q.y + q.z) / 3.0);
    const glm::dvec3 place = q - cell + (cell.x + cell.y + cell.z) / 6.0;
    const auto at = static_cast<std::size_t>(i);
    block.cell.at(at) = glm::ivec4(glm::ivec3(cell), 0);
    block.place.at(at) = glm::vec4(glm::dvec4(place, f));
    frequency *= terrain.lacunarity;
  }
  return block;
}

}  // namespace terrella
