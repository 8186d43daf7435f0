// What can be seen of a ground of nodes. Lengths in planet radii.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include <glm/vec3.hpp>

#include "planet/node_outline.hpp"
#include "planet/pose.hpp"

namespace terrella {

struct NodeSight {
  glm::dvec3 eye;
  std::array<glm::dvec3, 4> sides;  // unit, inwards, of the planes through the eye
  double occluder;                  // radius of a sphere that hides what lies behind it
  bool mountains_hide = false;      // whether nodes are left out of which nothing can be seen over nearer ones
  double sea = 0.0;                 // radius up to which a sea lies over lower ground; 0: there is none
  // By how much it is raised: a part of its distance, and never more than that (Needs).
  double sea_lift = 0.0, most_sea_lift = 0.0;
  double sea_hides = 0.0;                                     // depth of the ground from which nothing of it is seen
  double farthest = std::numeric_limits<double>::infinity();  // from where nothing is seen
  double sea_swell = 0.0;  // by how much waves raise it, or move it aside, at the most
  // What the sea mirrors, if it mirrors land.
  struct MirrorSight {
    glm::dvec3 eye;                   // the mirrored one
    std::array<glm::dvec3, 4> sides;  // as those of the picture
    double height;                    // of the true eye over the sea
    double pixel;                     // rad
  };
  std::optional<MirrorSight> mirror = std::nullopt;

  // Radius of the highest sea over a node.
  [[nodiscard]] double top_of_sea(const NodeOutline& node) const;
};

// rows: of the picture.
NodeSight node_sight(const Pose& pose, const View& view, const Rows& rows, double occluder);

}  // namespace terrella
