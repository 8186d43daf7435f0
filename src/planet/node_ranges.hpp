// How finely a ground of nodes is drawn where: by distance alone, so that neighbours agree without asking each other,
// and each level takes on the shape of the coarser one before it gives way to it (Strugar 2009, "Continuous
// distance-dependent level of detail for rendering heightmaps"). Lengths in planet radii.
#pragma once

#include <glm/vec3.hpp>

#include "formulas/formulas.hpp"
#include "planet/node_grid.hpp"
#include "planet/pose.hpp"

namespace terrella {

// An eye over a ground of nodes. Its distance to a place of the ground is told from the place's direction, whatever the
// ground's height there: sqrt(lift^2 + chord^2), the chord from the direction of the eye. The lift is how far the
// nearest ground is away (lift_over), so that nodes far from below the eye are divided by how far they are, those below
// it as if they were farther.
struct NodeEye {
  glm::dvec3 direction{0.0};  // unit
  double lift = 0.0;
};

// Who looks down on ground sees its heights foreshortened, and so what triangles miss of them. nearest: distance of the
// nearest ground. Returns twice as much from close by, and about the same from afar, where an outline lies at an angle
// from which it is seen from the side: its triangles come out larger by a fiftieth at the most.
double lift_over(double nearest);

// From heights around the place below the eye.
NodeEye eye_over(const f64::Terrain& terrain, const Pose& pose);

// All widths as multiples of the longest side of a node (NodeGrid::edge).
struct NodeRanges {
  double split = 2.5;  // nearer than this a node is split in four
  int deepest = deepest_level;
  int cells = most_cells;  // along a side of a node
  double reach = 1.4143;   // of a node (NodeGrid::reach)

  // From where to where a vertex passes from its own shape to that of the level above. Where it begins, no finer node
  // is left: those reach a node's width further than they are wanted. Where it ends, the level above is fine enough.
  [[nodiscard]] double morph_begin() const { return split + reach; }
  [[nodiscard]] double morph_end() const { return 2.0 * split; }
};

// A split below this would leave too little room to pass from shape to shape: a step of 1 % nearer takes a vertex a
// twentieth of the way.
constexpr double least_split(double reach) { return reach + 1.0857; }

}  // namespace terrella
