// An icosphere in groups of triangles, so that what cannot be seen need not be drawn.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "planet/icosphere.hpp"

namespace terrella {

// A group is what subdivision made of one triangle of this level; the finer triangles keep that order.
inline constexpr int group_level = 4;
inline constexpr std::size_t group_count = 20U << (2 * group_level);

// Triangles [first, end) of an icosphere.
struct TriangleRun {
  std::uint32_t first, end;
  bool operator==(const TriangleRun&) const = default;
};

// Between which radii a surface lies, planet radii.
struct RadiusRange {
  double lowest = 0.0, highest = 0.0;
};

// How far (part of the radius) the flat triangles of a level dip below the sphere through their corners, at the most.
double icosphere_sag(int level);

// The range of the surface over each group. positions: of the vertices of an icosphere of a level, group_level or finer,
// planet radii.
std::vector<RadiusRange> radius_ranges(const Icosphere& sphere, int level, std::span<const glm::vec3> positions);

// The triangles of a level (group_level or finer) that may be seen from an eye. eye: planet radii from the centre;
// occluder: radius of a sphere that lies within the surface; tops: how high the surface rises over each of the groups,
// planet radii, 0 where there is nothing to draw. From within the occluder all that is there may be seen.
std::vector<TriangleRun> visible_triangles(int level, const glm::dvec3& eye, double occluder, std::span<const float> tops);

}  // namespace terrella
