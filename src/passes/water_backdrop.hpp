// Water as it is seen where nothing else is, by an eye in it.
#pragma once

#include "gl/mesh.hpp"
#include "gl/program.hpp"
#include "passes/frame.hpp"

namespace terrella {

class WaterBackdrop {
 public:
  bool ready() { return program_.ready(); }

  // Before all that has a depth, which it leaves as it is.
  void draw(const Frame& frame);
  // After that: nothing shows any more before what the water shows.
  void close();

 private:
  gl::Program program_{"water/backdrop"};
  gl::FullScreen triangle_;
};

}  // namespace terrella
