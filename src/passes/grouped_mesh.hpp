// A mesh over the sphere of which some groups of triangles are drawn (planet/icosphere_groups.hpp).
#pragma once

#include <span>
#include <vector>

#include "gl/mesh.hpp"
#include "planet/icosphere_groups.hpp"

namespace terrella {

class GroupedMesh {
 public:
  GroupedMesh(std::span<const glm::vec3> vertices, GroupedTriangles triangles);

  // Other triangles between the same vertices.
  void set(GroupedTriangles triangles);

  // Draws groups, in one call, without the triangles that lie whole below a radius. Uploads their indices where they
  // are not those of the last time.
  void draw(std::vector<std::uint32_t> groups, double lowest = 0.0);

 private:
  gl::Mesh mesh_;
  GroupedTriangles triangles_;
  std::vector<float> radii_;           // of the vertices
  std::vector<std::uint32_t> groups_;  // those whose indices are on the GPU
  double lowest_ = 0.0;                // and what was left out of them
};

}  // namespace terrella
