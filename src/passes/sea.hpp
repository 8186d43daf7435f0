// The sea as a sphere: calm with ripples (Sandahl 12, 13), or with trochoidal waves (Sandahl 14 to 16).
#pragma once

#include "gl/uniform_buffer.hpp"
#include "passes/frame.hpp"
#include "passes/sphere_meshes.hpp"

namespace terrella {

class SeaPass {
 public:
  // technique: calm or waves.
  SeaPass(Water technique, SphereMeshes& spheres);

  bool ready() { return program_.ready(); }
  void draw(const Frame& frame);

 private:
  SphereMeshes& spheres_;
  gl::Program program_;
  gl::UniformBuffer waves_;
};

}  // namespace terrella
