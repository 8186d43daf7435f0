// Which directions of the sky a picture shows.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "passes/frame.hpp"

namespace terrella {

class SkyView {
 public:
  explicit SkyView(const Frame& frame);

  // Whether something about a direction (unit), not wider than margin, may be in the rows of the picture that are
  // drawn.
  [[nodiscard]] bool within_picture(const glm::vec3& direction) const {
    return picture_.holds(direction) && glm::dot(low_, direction) >= 0.0F && glm::dot(high_, direction) >= 0.0F;
  }
  // Whether the planet hides a direction.
  [[nodiscard]] bool behind_planet(const glm::vec3& direction) const { return planet_.holds(direction); }

  static constexpr double margin = 0.06;  // rad

 private:
  // A cone around directions; all of space where the cosine is -1, nothing where it is above 1.
  struct Cone {
    glm::vec3 axis;
    float cosine;
    [[nodiscard]] bool holds(const glm::vec3& direction) const;
  };

  Cone picture_, planet_;
  glm::vec3 low_, high_;  // inwards from the planes around the rows
};

}  // namespace terrella
