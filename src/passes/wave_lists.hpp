// The short waves of the sea on the GPU, anew for each eye and moment.
#pragma once

#include "gl/uniform_buffer.hpp"
#include "passes/frame.hpp"

namespace terrella {

class WaveLists {
 public:
  // Tells shaders/node_waves.glsl the waves of a frame. Of more than there is room for, the shortest only roughen the
  // water.
  void set(const Frame& frame);

 private:
  gl::UniformBuffer first_, second_;
};

}  // namespace terrella
