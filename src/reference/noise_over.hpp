// Between which values noise lies around a place where it is known.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "formulas/formulas.hpp"
#include "reference/directions.hpp"
#include "reference/range.hpp"

namespace terrella::reference {

// The noise of a layer where it was last computed.
struct KnownNoise {
  glm::dvec3 direction;  // unit
  f64::Noise noise;
};

// Bounds of a layer of noise over directions, told from its value and slope at any one, within them or not, by how fast
// slopes change on the way (planet/noise_bounds.hpp): the wider the further it is away. frequency: cells per radian.
Range noise_over(const Directions& directions, const KnownNoise& known, double frequency);

// Remembers the noise of layers along a ray: coarse ones hardly change from piece to piece. Layers count from 0, the
// coarsest, up to the given number.
class NoiseMemory {
 public:
  explicit NoiseMemory(int layers) : layers_(static_cast<std::size_t>(layers)) {}

  // Whether what is known of a layer tells nearly as much of it over directions as its noise at their middle would.
  [[nodiscard]] bool tells_of(const Directions& directions, int layer, double frequency) const;

  [[nodiscard]] const KnownNoise& of(int layer) const { return *layers_[static_cast<std::size_t>(layer)]; }
  void keep(int layer, const KnownNoise& known) {
    layers_[static_cast<std::size_t>(layer)] = known;
    ++kept_;
  }

  // How often noise was computed.
  [[nodiscard]] long kept() const { return kept_; }

 private:
  std::vector<std::optional<KnownNoise>> layers_;
  long kept_ = 0;
};

}  // namespace terrella::reference
