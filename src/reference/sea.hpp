// The true surface of a scene's water. Lengths in planet radii.
#pragma once

#include <optional>

#include "planet/waves.hpp"
#include "reference/ground.hpp"
#include "reference/ray.hpp"

namespace terrella::reference {

// Where the water of a place has gone.
struct WaterAt {
  glm::dvec3 still;  // direction (unit) in which it would be without waves
  f64::Frame frame;  // there
  f64::WaveSum sum;  // held by the ground
  double depth;      // of the still water there; at most 0: land
  glm::dvec3 place;
};

class Sea {
 public:
  // ground: of the same scene, kept; nothing where the scene has none.
  Sea(const Scene& scene, double seconds, const Ground* ground);

  [[nodiscard]] double still_radius() const { return radius_; }
  [[nodiscard]] double whole_depth() const { return whole_depth_; }
  [[nodiscard]] bool has_waves() const { return !sea_.waves.empty(); }

  // Depth of the still water over the ground at a direction (unit); at most 0: land.
  [[nodiscard]] double depth_at(const glm::dvec3& direction) const;

  // The water that stands over a direction (unit): of which, moved by the waves, lies there.
  [[nodiscard]] WaterAt over(const glm::dvec3& direction) const;

  // As first_hit asks for them.
  [[nodiscard]] double radius_at(const glm::dvec3& direction) const { return glm::length(over(direction).place); }
  [[nodiscard]] bool stays_below(const glm::dvec3& direction, double chord, double radius) const;

  // Where a ray that begins above the water meets it, no further than `before`.
  [[nodiscard]] std::optional<double> hit(const Ray& ray, double before, const Resolution& resolution) const;

 private:
  [[nodiscard]] WaterAt from(const glm::dvec3& still) const;
  [[nodiscard]] f64::WaveSum whole_sum(const glm::dvec3& still, const f64::Frame& frame) const;

  terrella::Sea sea_;
  double radius_, whole_depth_;
  double most_shift_ = 0.0;  // no water moves further aside
  const Ground* ground_;
};

}  // namespace terrella::reference
