// The band of far stars across the sky: dim points, and the glow of those too many to be told apart.
#pragma once

#include <cstdint>
#include <vector>

#include "planet/stars.hpp"

namespace terrella {

// Normal (unit) of the plane that it lies around.
glm::dvec3 milky_band_normal(const Scene& scene);

// Brightness of its glow at a direction (unit), 0..1.
double milky_band_brightness(const Scene& scene, const glm::dvec3& direction);

// Its points. None where stars.band is 0.
StarSky find_band_stars(const Scene& scene);

// Its glow as squares of two triangles each, by which it is interpolated: a belt around the sky.
struct BandGlow {
  std::vector<glm::vec3> vertices;     // direction times (1 + brightness), brightness 0..1
  std::vector<std::uint32_t> indices;  // six a square
  std::int64_t noise_evaluations = 0;
};

// Empty where stars.band is 0.
BandGlow find_band_glow(const Scene& scene);

// Angle between the corners of a square, rad, at the most.
inline constexpr double band_square = 0.03;

}  // namespace terrella
