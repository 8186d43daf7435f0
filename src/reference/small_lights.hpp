// Lights that are smaller than a pixel or about as large: stars and towns, which a picture shows as soft discs.
#pragma once

#include <limits>
#include <vector>

#include "formulas/formulas.hpp"
#include "planet/pose.hpp"
#include "scene/scene.hpp"

namespace terrella::reference {

class SmallLights {
 public:
  SmallLights(const Scene& scene, const View& view, const Pose& pose, const f64::SceneLight& light);

  // Light that reaches a place of the picture (pixels from the top left) past a surface at a depth: along pose.forward,
  // planet radii, infinite for the sky.
  [[nodiscard]] glm::dvec3 at(const glm::dvec2& pixel, double depth) const;

 private:
  struct Disc {
    glm::dvec2 pixel;
    double radius;  // pixels
    double depth;   // as above
    glm::dvec3 light;
  };

  void add(const glm::dvec3& offset, double depth, double radius, const glm::dvec3& light);
  void sort_into_cells();

  View view_;
  Pose pose_;
  std::vector<Disc> discs_;
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<std::size_t>> cells_;  // discs that touch each square of the picture
};

}  // namespace terrella::reference
