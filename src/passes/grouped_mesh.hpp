// A mesh over the sphere of which some groups of triangles are drawn (planet/icosphere_groups.hpp).
#pragma once

#include <span>
#include <vector>

#include "gl/mesh.hpp"
#include "passes/frame.hpp"
#include "passes/kept_parts.hpp"
#include "planet/icosphere_groups.hpp"

namespace terrella {

class GroupedMesh {
 public:
  GroupedMesh(std::span<const glm::vec3> vertices, GroupedTriangles triangles);

  // Other triangles between the same vertices.
  void set(GroupedTriangles triangles);

  // Draws groups, in one call, without the triangles that lie whole below a radius. Uploads their indices where they
  // are new. frame: for whose rows they are.
  void draw(const Frame& frame, Chosen groups, double lowest = 0.0);

 private:
  gl::Mesh mesh_;
  GroupedTriangles triangles_;
  std::vector<float> radii_;        // of the vertices
  KeptParts<std::uint32_t> parts_;  // of groups
  double lowest_ = 0.0;             // what was left out of them
};

}  // namespace terrella
