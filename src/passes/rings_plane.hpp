// Rings in the plane of the equator, and their shadow on the planet.
#pragma once

#include "gl/mesh.hpp"
#include "gl/program.hpp"
#include "passes/frame.hpp"
#include "passes/sphere_meshes.hpp"

namespace terrella {

class RingsPlane {
 public:
  explicit RingsPlane(SphereMeshes& spheres) : spheres_(spheres) {}

  bool ready() { return program_.ready() && shadow_program_.ready(); }

  // What lies further than the place where a ray comes nearest to the planet, and what lies before it.
  void draw_behind() { draw(-1.0F); }
  void draw_before() { draw(1.0F); }

  // Darkens what is drawn already; nothing where the eye is under what the shadow falls on:
  // there it is the sun that is darkened (frame_block).
  void draw_shadow(const Frame& frame);

 private:
  void draw(float side);

  SphereMeshes& spheres_;
  gl::Program program_{"rings/plane"};
  gl::Program shadow_program_{"rings/shadow", "clouds/shell"};
  gl::Strip strip_;
};

}  // namespace terrella
