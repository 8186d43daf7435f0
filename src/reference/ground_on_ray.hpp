// A ground as first_hit asks for it along a ray, or several one after the other: what has been learnt of it on the way
// is kept. Each thread needs one of its own.
#pragma once

#include "reference/ground.hpp"

namespace terrella::reference {

class GroundOnRay {
 public:
  // ground: kept.
  explicit GroundOnRay(const Ground& ground) : ground_(ground), memory_(ground.no_memory()) {}

  [[nodiscard]] double radius_at(const glm::dvec3& direction) const { return ground_.radius_at(direction); }
  [[nodiscard]] bool reaches(const glm::dvec3& direction, double radius) const {
    return ground_.reaches(direction, radius);
  }
  [[nodiscard]] bool stays_below(const Directions& directions, double radius) const {
    return ground_.stays_below(directions, radius, memory_);
  }

 private:
  const Ground& ground_;
  mutable NoiseMemory memory_;
};

}  // namespace terrella::reference
