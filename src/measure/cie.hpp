// Colours as the CIE describes them.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

namespace terrella {

// The exact curve: the picture's own (lib/color.glsl) is fitted within 4e-5.
inline double linear_of_srgb(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

// CIE XYZ of the sRGB primaries under D65, relative to white. c: linear light.
inline glm::dvec3 xyz_of(const glm::dvec3& c) {
  const glm::dvec3 xyz(0.4123865632 * c.r + 0.3575914909 * c.g + 0.1804504912 * c.b,
                       0.2126368217 * c.r + 0.7151829818 * c.g + 0.0721801965 * c.b,
                       0.0193306202 * c.r + 0.1191971636 * c.g + 0.9503725870 * c.b);
  return xyz / glm::dvec3(0.9504285453, 1.0, 1.0889003708);
}

// CIE 1976 L*a*b*.
inline glm::dvec3 lab_of(const glm::dvec3& xyz) {
  constexpr double limit = 6.0 / 29.0;
  const auto f = [](double t) {
    return t > limit * limit * limit ? std::cbrt(t) : t / (3.0 * limit * limit) + 4.0 / 29.0;
  };
  return {116.0 * f(xyz.y) - 16.0, 500.0 * (f(xyz.x) - f(xyz.y)), 200.0 * (f(xyz.y) - f(xyz.z))};
}

}  // namespace terrella
