// The true ground of a scene: all its layers, at any place. Lengths in planet radii.
#pragma once

#include <optional>

#include "formulas/formulas.hpp"
#include "reference/directions.hpp"
#include "reference/noise_over.hpp"
#include "reference/range.hpp"
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

  // Bounds of the heights of directions, by as many layers and sizes of craters as are needed to tell them from some
  // heights: what is left rises and digs no further than its range. memory: of the layers of this ground, wherever they
  // were computed.
  [[nodiscard]] Range heights_over(const Directions& directions, const Range& told_from, NoiseMemory& memory) const;
  [[nodiscard]] Range heights_over(const Directions& directions, const Range& told_from) const;
  [[nodiscard]] NoiseMemory no_memory() const { return NoiseMemory(terrain_.octaves); }

  // As first_hit asks for them.
  [[nodiscard]] bool reaches(const glm::dvec3& direction, double radius) const;
  [[nodiscard]] bool stays_below(const Directions& directions, double radius, NoiseMemory& memory) const;

  // Where a ray that begins above the ground meets it, no further than `before`. resolution: as of first_hit.
  [[nodiscard]] std::optional<double> hit(const Ray& ray, double before, const Resolution& resolution) const;

  // No ground lies higher.
  [[nodiscard]] double highest() const { return highest_; }

 private:
  // Of the noise of one layer, of that layer made of it, ridged or not, 0..1, and of one size of craters, radii.
  [[nodiscard]] Range noise_over(const Directions& directions, double frequency, int octave, NoiseMemory& memory) const;
  [[nodiscard]] Range layer_of(const Range& noise, double frequency, bool ridged) const;
  [[nodiscard]] Range craters_around(const glm::dvec3& direction, double chord, double frequency, int size) const;
  [[nodiscard]] double left_in(double value, double frequency, bool ridged) const;
  void sum_layers();
  // Of the map, 0..1, and of the ground by what layers and craters add to it, radii.
  [[nodiscard]] Range map_around(const glm::dvec3& direction, double chord) const;
  [[nodiscard]] Range heights_on(const Range& map, const Range& added) const;
  // Of the ice, 0 where there is none: as heights_over, without the ground under it.
  [[nodiscard]] Range ice_over(const glm::dvec3& direction, double chord, const Range& told_from) const;
  // From the means of all layers, 0..1: without ranges, and what those add; ridges: of them, 0..1.
  [[nodiscard]] Range heights_of(const Range& means) const;
  [[nodiscard]] Range ranges_over(const Range& means, const Range& ridges) const;

  f64::Terrain terrain_;
  SharedHeightMap map_;  // that terrain_ reads
  int beyond_map_ = 0;   // the first layer that the map does not stand for
  double footprint_;
  // Layers and sizes of craters of which the footprint leaves anything; those are the coarsest.
  int shown_layers_ = 0, shown_sizes_ = 0;
  // Sums of the amplitudes of all layers, and of those that the footprint leaves at their mean.
  double total_ = 0.0, hidden_ = 0.0;
  // The same of those that are ridged for ranges as well, with the amplitude of the first.
  double total_ridges_ = 0.0, hidden_ridges_ = 0.0, first_ridges_ = 0.0;
  double highest_;             // radius
  double crater_cells_ = 0.0;  // their depth times the width of a cell, summed over all that are shown, radii
};

}  // namespace terrella::reference
