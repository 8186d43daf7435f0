// The icospheres that several passes draw, made once each.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "gl/mesh.hpp"
#include "planet/icosphere_groups.hpp"

namespace terrella {

class SphereMeshes {
 public:
  // The geometry of a level, on the CPU.
  const Icosphere& geometry(int level);

  // A mesh of unit directions of a level, on the GPU.
  gl::Mesh& directions(int level);

  // Draws what of a mesh of a level may be seen; arguments as for visible_triangles.
  static void draw_visible(gl::Mesh& mesh, int level, const glm::dvec3& eye, double occluder, std::span<const float> tops);

 private:
  std::array<std::unique_ptr<Icosphere>, max_icosphere_level + 1> geometry_;
  std::array<std::unique_ptr<gl::Mesh>, max_icosphere_level + 1> directions_;
};

}  // namespace terrella
