// The sea as a sphere: calm with ripples (Sandahl 12, 13), or with trochoidal waves (Sandahl 14 to 16).
#pragma once

#include <optional>
#include <span>

#include "gl/program_choice.hpp"
#include "gl/uniform_buffer.hpp"
#include "passes/ground.hpp"
#include "passes/wave_lists.hpp"

namespace terrella {

class SeaPass {
 public:
  // technique: calm or waves.
  SeaPass(Water technique, SphereMeshes& spheres);

  // Starts to compile the program that the needs call for, where land stands in the water's mirror as in the last
  // frame.
  void want(const Needs& needs);
  // Says whether it does in this one.
  void mirror_land(const Needs& needs, bool mirrors_land);
  // True once drawing will not wait for it.
  bool ready() { return program_->ready() && (!deep_program_ || deep_program_->ready()); }

  // Whether it was drawn as its last wish was.
  [[nodiscard]] bool settled() const { return program_->settled() && (!deep_program_ || deep_program_->settled()); }

  // Tells the waves of a frame to whatever is drawn in it.
  void set_waves(const Frame& frame);

  // ground: or nothing. Where it stands out of the water whole, no water is drawn; of one of nodes the sea takes those.
  void draw(const Frame& frame, const GroundPass* ground);

 private:
  void draw_over(const Frame& frame, const NodeMeshes& nodes);
  void draw_sphere(const Frame& frame, std::span<const RadiusRange> ground);

  Water technique_;
  SphereMeshes& spheres_;
  std::optional<gl::ProgramChoice> program_;
  std::optional<gl::ProgramChoice> deep_program_;  // over nodes whose ground is not seen
  bool over_nodes_ = false, mirrors_land_ = false;
  gl::UniformBuffer waves_;
  WaveLists short_waves_;
};

}  // namespace terrella
