// Which places near a planet's surface a picture shows, but for mountains that stand before them. Lengths in planet
// radii.
#pragma once

#include "planet/needs.hpp"

namespace terrella {

class SeenPlaces {
 public:
  // view: without shift and field.
  SeenPlaces(const Scene& scene, const View& view, const Pose& pose, const Needs& needs);

  // Where a place before the eye appears, pixels right and up from the picture's middle.
  [[nodiscard]] glm::dvec2 pixel_of(const glm::dvec3& place) const;

  // From the eye to what pixel_of tells, unit.
  [[nodiscard]] glm::dvec3 ray_to(const glm::dvec2& pixel) const;

  // Whether sea or planet lies before a place, or around it.
  [[nodiscard]] bool is_hidden(const glm::dvec3& place) const;

  // Whether a triangle, counter-clockwise from outside, turns to the eye and has something in the picture with neither
  // sea nor planet before it, as far as its corners tell.
  [[nodiscard]] bool is_seen(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const;

 private:
  Pose pose_;
  glm::dvec2 half_;      // of the picture, pixels
  double pixels_a_tan_;  // in its middle
  double solid_;         // radius of the sphere that hides what lies in it and behind it
};

}  // namespace terrella
