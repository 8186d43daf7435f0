// A sphere around the planet that lets through what is behind it.
#pragma once

#include "gl/program.hpp"
#include "passes/frame.hpp"
#include "passes/sphere_meshes.hpp"

namespace terrella {

// Draws what can be seen of it: from above its near side, from below all of it that the ground does not hide. program:
// with the vertex shader clouds/shell; level: of the icosphere; radius: planet radii.
void draw_shell(SphereMeshes& spheres, gl::Program& program, const Frame& frame, int level, double radius);

}  // namespace terrella
