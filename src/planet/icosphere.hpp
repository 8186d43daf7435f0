// The subdivided icosahedron (Sandahl 2022, section 2.1): triangles of nearly one size all over the sphere.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace terrella {

inline constexpr int max_icosphere_level = 8;

struct Icosphere {
  std::vector<glm::dvec3> directions;  // unit; every vertex once
  std::vector<std::uint32_t> indices;  // three a triangle, counter-clockwise seen from outside
};

// 20 * 4^level triangles and 10 * 4^level + 2 vertices. level: 0..max_icosphere_level.
Icosphere make_icosphere(int level);

// Length of the longest edge, rad. level as above.
double icosphere_edge(int level);

// The triangle that a direction passes through.
struct IcospherePlace {
  std::array<glm::dvec3, 3> corners;  // unit
  glm::dvec3 weights;                 // barycentric where the ray meets the flat triangle; their sum is 1
};

// direction: any length but 0.
IcospherePlace locate_on_icosphere(const glm::dvec3& direction, int level);

}  // namespace terrella
