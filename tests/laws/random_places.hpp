// Numbers for laws to be tried on: the same on every machine.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace terrella::test {

class Places {
 public:
  explicit Places(unsigned seed) : random_(seed) {}

  double between(double low, double high) { return low + (high - low) * static_cast<double>(random_()) / 4294967295.0; }

  glm::dvec3 in_cube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }

  glm::dvec3 on_sphere() {
    const double z = between(-1.0, 1.0), angle = between(0.0, 2.0 * std::numbers::pi);
    const double r = std::sqrt(std::fmax(0.0, 1.0 - z * z));
    return {r * std::cos(angle), r * std::sin(angle), z};
  }

 private:
  std::mt19937 random_;
};

}  // namespace terrella::test
