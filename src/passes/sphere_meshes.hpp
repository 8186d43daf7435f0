// The icospheres that several passes draw, made once each.
#pragma once

#include <array>
#include <memory>

#include "gl/mesh.hpp"
#include "planet/icosphere.hpp"

namespace terrella {

class SphereMeshes {
 public:
  // The geometry of a level, on the CPU.
  const Icosphere& geometry(int level);

  // A mesh of unit directions of a level, on the GPU.
  const gl::Mesh& directions(int level);

  // Draws what of a mesh of a level may be seen. lowest, highest: radii between which its surface lies.
  static void draw_visible(const gl::Mesh& mesh, int level, const glm::dvec3& eye, double lowest, double highest);

 private:
  std::array<std::unique_ptr<Icosphere>, max_icosphere_level + 1> geometry_;
  std::array<std::unique_ptr<gl::Mesh>, max_icosphere_level + 1> directions_;
};

}  // namespace terrella
