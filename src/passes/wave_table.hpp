// The short waves of the sea on the GPU, anew for each eye and moment.
#pragma once

#include <optional>

#include "gl/texture.hpp"
#include "gl/uniform_buffer.hpp"
#include "passes/frame.hpp"

namespace terrella {

class WaveTable {
 public:
  // Tells shaders/node_waves.glsl the waves of a frame.
  void set(const Frame& frame);

 private:
  std::optional<gl::Image> waves_;
  gl::UniformBuffer anchor_;
};

}  // namespace terrella
