// An icosphere in groups of triangles, so that what cannot be seen need not be drawn.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "planet/icosphere.hpp"

namespace terrella {

// A group is what subdivision made of one triangle of this level; the finer triangles keep that order.
inline constexpr int group_level = 4;
inline constexpr std::size_t group_count = 20U << (2 * group_level);

// Triangles, those of each group together.
struct GroupedTriangles {
  std::vector<std::uint32_t> indices;  // three a triangle, counter-clockwise from outside
  std::vector<std::uint32_t> starts;   // first triangle of each group, and the end of the last: group_count + 1
};

// All triangles of an icosphere of a level, group_level or finer.
GroupedTriangles all_triangles(const Icosphere& sphere);

// Fewer triangles between the same vertices, without cracks: a triangle of a coarser level is split in four where the
// middle of one of its edges lies further than tolerance from the straight edge, and in two or three where only a
// neighbour is ("red-green" refinement, Bank, Sherman & Weiser 1983). So no vertex that is left out lies further
// than 2.5 tolerances from the triangles there, over two levels. sphere: of group_level or finer; positions: of its
// vertices, planet radii; tolerance: planet radii, 0 for all triangles.
GroupedTriangles simplified(const Icosphere& sphere, std::span<const glm::vec3> positions, double tolerance);

// Between which radii a surface lies, planet radii.
struct RadiusRange {
  double lowest = 0.0, highest = 0.0;
};

// How far (part of the radius) the flat triangles of a level dip below the sphere through their corners, at the most.
double icosphere_sag(int level);

// The range of the surface over each group, whichever of its triangles are drawn. sphere, positions: as above.
std::vector<RadiusRange> radius_ranges(const Icosphere& sphere, std::span<const glm::vec3> positions);

// What an eye can see: a cone around a direction, and of that what lies between two planes through the eye.
struct Sight {
  glm::dvec3 eye;                     // planet radii from the centre
  glm::dvec3 forward{1.0, 0.0, 0.0};  // unit
  double half_angle = 4.0;            // rad; pi or more: all around
  std::array<glm::dvec3, 2> sides{};  // unit, pointing inwards; 0 where there is no plane
};

// The groups that may be seen, in order. occluder: radius of a sphere that lies within the surface; tops: how high the
// surface rises over each of the groups, planet radii, 0 where there is nothing to draw. From within the occluder all
// that is there may be seen.
std::vector<std::uint32_t> visible_groups(const Sight& sight, double occluder, std::span<const float> tops);

}  // namespace terrella
