// The air before the sky (Sandahl 2022, section 2.4); surfaces take the air before them into account themselves.
#pragma once

#include "gl/mesh.hpp"
#include "gl/program.hpp"
#include "passes/frame.hpp"

namespace terrella {

class AirFresnel {
 public:
  bool ready() { return program_.ready(); }
  void draw(const Frame& frame);

 private:
  gl::Program program_{"air/fresnel"};
  gl::Strip strip_;
};

}  // namespace terrella
