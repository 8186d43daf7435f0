// What drawn mountains hide of the ground behind them, about as finely as a picture of usual size shows.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace terrella {

class GroundSkyline {
 public:
  // eye: planet radii.
  explicit GroundSkyline(const glm::dvec3& eye);

  // Whether what was added so far stands before a place.
  [[nodiscard]] bool hides(const glm::dvec3& place) const;

  // Triangles between vertices, three each. Everything nearer must have been added before.
  void add(const std::vector<glm::dvec3>& vertices, const std::vector<std::uint16_t>& triangles);

 private:
  struct Sight {
    double column;     // 0..columns
    double elevation;  // its tangent
  };
  [[nodiscard]] Sight sight_of(const glm::dvec3& place) const;
  void add_edge(Sight a, Sight b);

  glm::dvec3 eye_, up_, along_, across_;
  std::vector<double> highest_;  // of each column
};

}  // namespace terrella
