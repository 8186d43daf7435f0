// The piece of the unit sphere that a node covers, as what is asked of it: how near and how far it is, and what side of
// a plane it lies on.
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "planet/node_grid.hpp"

namespace terrella {

struct NodeOutline {
  glm::dvec3 middle{0.0};               // unit
  double half_width = 0.0;              // nothing is further from the middle
  std::array<glm::dvec3, 4> corners{};  // unit, one after another around it; of a triangle the first comes again
  // Unit, of the planes of its sides, which begin at each corner and go through the sphere's middle; 0 where there is
  // none.
  std::array<glm::dvec3, 4> outwards{};
  double bulge = 0.0;  // how far sides are from the great circles from corner to corner
};

// patch: of the grid, of any number of cells; the more, the closer its sides.
NodeOutline outline_of(const NodeGrid& grid, const NodePatch& patch, const GridNode& node);

// How far from a direction (unit) the nearest place and the farthest are, as chords. Of nodes that cover much of the
// sphere the first is too small, by as much as a chord lies below its arc.
double nearest_to(const NodeOutline& outline, const glm::dvec3& direction);
double farthest_from(const NodeOutline& outline, const glm::dvec3& direction);

// From a place to the nearest of the straight line from a to b.
double distance_to_line(const glm::dvec3& from, const glm::dvec3& a, const glm::dvec3& b);

// Whether all that lies over it, between two radii, is on the far side of a plane through the eye, and further from it
// than a distance. inwards: unit.
bool is_outside(const NodeOutline& outline, double lowest, double highest, const glm::dvec3& eye,
                const glm::dvec3& inwards, double beyond);

}  // namespace terrella
