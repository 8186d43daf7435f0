// The true surface of a scene's water. Lengths in planet radii.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "planet/waves.hpp"
#include "reference/directions.hpp"
#include "reference/ground.hpp"
#include "reference/range.hpp"
#include "reference/ray.hpp"

namespace terrella::reference {

// Depth of a sea without a ground, radii: of which nothing is seen but the water.
inline constexpr double bottomless = 1e3;

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
  [[nodiscard]] bool has_waves() const { return !sea_.is_calm(); }
  [[nodiscard]] const f64::Breaking& breaking() const { return sea_.breaking; }
  // What tears the foam of surf at a still place.
  [[nodiscard]] f64::FoamLace lace_at(const glm::dvec3& still) const;
  [[nodiscard]] double amplitude() const { return sea_.amplitude; }

  // How many times as much sunlight waves gather on the bottom, where it enters the water at a still place (unit) and
  // goes on for a way.
  [[nodiscard]] double gathered_at(const glm::dvec3& still, double way, double refraction_index) const;

  // Depth of the still water over the ground at a direction (unit); at most 0: land.
  [[nodiscard]] double depth_at(const glm::dvec3& direction) const;

  // The water that stands over a direction (unit): of which, moved by the waves, lies there.
  [[nodiscard]] WaterAt over(const glm::dvec3& direction) const;

  // As first_hit asks for them.
  [[nodiscard]] double radius_at(const glm::dvec3& direction) const { return glm::length(over(direction).place); }
  [[nodiscard]] bool reaches(const glm::dvec3& direction, double radius) const;
  [[nodiscard]] bool stays_below(const Directions& directions, double radius) const;
  [[nodiscard]] bool stays_above(const Directions& directions, double radius) const;

  // Where a ray that begins above the water meets it, no further than `before`.
  [[nodiscard]] std::optional<double> hit(const Ray& ray, double before, const Resolution& resolution) const;
  // The same for one that begins in it.
  [[nodiscard]] std::optional<double> hit_from_below(const Ray& ray, double before, const Resolution& resolution) const;

 private:
  // The water of a still place. deep: the ground is known to be too deep there to be felt.
  [[nodiscard]] WaterAt from(const glm::dvec3& still, bool deep) const;
  // The water over a direction, which lies within most_shift_ of its still place. beside: a radius; it is enough to
  // know on which side of it the water lies; 0: find it to the precision of doubles.
  [[nodiscard]] WaterAt over(const glm::dvec3& direction, bool deep, double beside = 0.0) const;
  [[nodiscard]] f64::WaveSum whole_sum(const glm::dvec3& still, const f64::Frame& frame, bool deep) const;
  // Bounds of the water over all directions within chord of a direction; no tighter than is needed to tell it from a
  // height.
  struct Around {
    Range heights;  // over the still sea
    double away;    // no water there comes from further
    bool deep;      // the ground is known to be too deep to be felt where it comes from
  };
  [[nodiscard]] Around around(const glm::dvec3& direction, double chord, double told_from) const;
  // The same as if the ground held nothing back. least_depth: of the water that may come to lie there.
  [[nodiscard]] Around whole_waves_around(const glm::dvec3& direction, double chord, double told_from,
                                          double least_depth) const;
  // Depths within a distance of a direction, no more exactly than waves feel them.
  [[nodiscard]] Range depths_around(const glm::dvec3& direction, double distance) const;
  // The ground that waves feel at a direction.
  [[nodiscard]] f64::Shore shore_at(const glm::dvec3& direction, const f64::Frame& frame) const;
  // shore: or nothing where the ground is known to be too deep to be felt.
  void add_wave(f64::WaveSum& sum, const glm::dvec3& still, const f64::Frame& frame, const f64::Wave& wave, double part,
                const f64::Shore* shore) const;
  [[nodiscard]] double most_of_deep_water(const WaterAt& middle, double chord) const;

  // Asks function(wave, part, most) for each wave that comes within a distance of a direction: how strong it is there,
  // and at the most around it, 0..1.
  template <class Function>
  void each_wave(const glm::dvec3& direction, double distance, const Function& function) const;

  terrella::Sea sea_;
  std::array<std::vector<f64::Wave>, regions> short_waves_;
  // How much of the waves the ground leaves, 0..1.
  [[nodiscard]] double left_over(double depth) const;

  double radius_, whole_depth_;
  bool over_nodes_;
  f64::Shore shore_;
  int foam_layer_;
  f64::Terrain terrain_;
  double most_shift_ = 0.0;  // no water moves further aside
  // No wave changes its slope, nor how it moves water aside, faster.
  double most_curvature_ = 0.0, most_squeeze_ = 0.0;
  const Ground* ground_;
  std::optional<Ground> felt_ground_;  // without what is much finer than the longest wave
};

}  // namespace terrella::reference
