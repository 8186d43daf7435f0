// The planet's surface as a map: longitude goes across, latitude up (equirectangular), with its relief lit from the
// northwest, as maps are drawn.
#pragma once

#include <span>

#include <glm/vec4.hpp>

#include "formulas/formulas.hpp"
#include "scene/scene.hpp"

namespace terrella {

class SurfaceMap {
 public:
  // height: rows of the map, >= 1.
  SurfaceMap(const Scene& scene, int height);

  // The colours of a row, from 0 at the north pole to height - 1, from longitude -180 to 180 degrees: sRGB, 0..1,
  // opaque.
  void make_row(int row, std::span<glm::vec4> colors) const;

 private:
  [[nodiscard]] glm::dvec3 light_at(const glm::dvec3& up, const glm::dvec3& east) const;
  [[nodiscard]] glm::dvec3 ground_at(const glm::dvec3& up, const f64::Height& height) const;

  bool has_ground_, has_water_;
  f64::Terrain terrain_;
  f64::Bands bands_;
  f64::WaterLook look_;
  double sea_;  // height of the water over the sphere, radii
  int height_;
};

}  // namespace terrella
