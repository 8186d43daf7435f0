// The sea as a sphere: calm with ripples (Sandahl 12, 13), or with trochoidal waves (Sandahl 14 to 16).
#pragma once

#include <vector>

#include "gl/program_choice.hpp"
#include "gl/uniform_buffer.hpp"
#include "passes/ground.hpp"

namespace terrella {

class SeaPass {
 public:
  // technique: calm or waves.
  SeaPass(Water technique, SphereMeshes& spheres);

  // Starts to compile the program that the needs call for.
  void want(const Needs& needs);
  // True once drawing will not wait for it.
  bool ready() { return over_nodes_ ? node_program_.ready() : program_.ready(); }

  // ground: or nothing. Where it stands out of the water whole, no water is drawn; of one of nodes the sea takes those.
  void draw(const Frame& frame, const GroundPass* ground);

 private:
  void draw_sphere(const Frame& frame, std::span<const RadiusRange> ground);

  SphereMeshes& spheres_;
  gl::ProgramChoice program_;  // over the sphere
  gl::ProgramChoice node_program_{"water/nodes"};
  bool over_nodes_ = false;
  gl::UniformBuffer waves_;
};

}  // namespace terrella
