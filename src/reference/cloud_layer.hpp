// The true clouds of a scene: all their layers, at any place and time.
#pragma once

#include <vector>

#include "formulas/formulas.hpp"
#include "planet/cloud_layers.hpp"
#include "scene/scene.hpp"

namespace terrella::reference {

class CloudLayer {
 public:
  // footprint: as of Footprints.
  CloudLayer(const Scene& scene, double seconds, double footprint = 0.0);

  [[nodiscard]] const f64::Clouds& clouds() const { return clouds_; }

  // What there is of clouds at a direction (unit). sun: unit.
  [[nodiscard]] f64::CloudAt at(const glm::dvec3& direction, const glm::dvec3& sun) const;

  // Part of the sunlight that they leave at a place (planet radii).
  [[nodiscard]] double shade(const glm::dvec3& place, const glm::dvec3& sun) const;

 private:
  [[nodiscard]] double noise(const glm::dvec3& direction) const;

  f64::Clouds clouds_;
  Cyclones cyclones_;
  glm::dvec2 drift_;
  std::vector<glm::dvec2> turns_;  // of each layer
  double footprint_;
  double frequency_, persistence_, warp_, belts_, swirl_;
  unsigned seed_;
};

}  // namespace terrella::reference
