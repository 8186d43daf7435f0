// The sea as a sphere: calm with ripples (Sandahl 12, 13), or with trochoidal waves (Sandahl 14 to 16).
#pragma once

#include <span>
#include <vector>

#include "gl/program_choice.hpp"
#include "gl/uniform_buffer.hpp"
#include "passes/frame.hpp"
#include "passes/sphere_meshes.hpp"

namespace terrella {

class SeaPass {
 public:
  // technique: calm or waves.
  SeaPass(Water technique, SphereMeshes& spheres);

  // Starts to compile the program that the needs call for.
  void want(const Needs& needs);
  // True once drawing will not wait for it.
  bool ready() { return program_.ready(); }

  // ground: over each group of the icosphere; empty where there is no ground. Where it stands out of the water whole,
  // no water is drawn.
  void draw(const Frame& frame, std::span<const RadiusRange> ground);

 private:
  SphereMeshes& spheres_;
  gl::ProgramChoice program_;
  gl::UniformBuffer waves_;
};

}  // namespace terrella
