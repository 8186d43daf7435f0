// The true ground of a scene: all its layers, at any place. Lengths in planet radii.
#pragma once

#include <optional>

#include "formulas/formulas.hpp"
#include "reference/ray.hpp"
#include "scene/scene.hpp"

namespace terrella::reference {

class Ground {
 public:
  // footprint: as of Footprints.
  explicit Ground(const Scene& scene, double footprint = 0.0);

  // Height over the unit sphere with its gradient. direction: unit.
  [[nodiscard]] f64::Height height_at(const glm::dvec3& direction) const;
  [[nodiscard]] double radius_at(const glm::dvec3& direction) const { return 1.0 + height_at(direction).value; }

  // As first_hit asks for them: by as many layers as are needed to tell. A layer of noise rises at most by its steepest
  // slope times the distance, and never beyond its range: a bound layer by layer, which ends as soon as it suffices.
  [[nodiscard]] bool reaches(const glm::dvec3& direction, double radius) const;
  [[nodiscard]] bool stays_below(const glm::dvec3& direction, double chord, double radius) const;

  // Where a ray that begins above the ground meets it, no further than `before`. resolution: as of first_hit.
  [[nodiscard]] std::optional<double> hit(const Ray& ray, double before, const Resolution& resolution) const;

  // No ground lies higher.
  [[nodiscard]] double highest() const { return highest_; }

 private:
  // A layer's value, or a bound of it, as much of it as is left in.
  [[nodiscard]] double left_in(double value, double frequency) const;
  [[nodiscard]] f64::Noise noise_at(const glm::dvec3& direction, double frequency, int layer) const;
  [[nodiscard]] double most_dug_up(const glm::dvec3& direction, double chord) const;

  f64::Terrain terrain_;
  double footprint_;
  double total_;                   // of the amplitudes of the layers
  double highest_;                 // radius
  double cells_of_craters_ = 0.0;  // their depth times the width of a cell, summed over all sizes, radii
};

}  // namespace terrella::reference
