// One picture of light gives way to another: both are drawn, and the mean of both is shown.
#pragma once

#include <memory>

#include "gl/mesh.hpp"
#include "gl/program.hpp"
#include "gl/target.hpp"

namespace terrella {

class LightFade {
 public:
  bool ready() { return program_.ready(); }

  // Directs drawing to the picture that gives way, and clears it within the scissors. size, format: of the other.
  void begin(const gl::Image& other);
  // Lays it over that other, which is drawn to again: of each channel it makes a part, 0..1.
  void blend(const gl::Target& other, double part);

 private:
  gl::Program program_{"picture/overlay", "picture/screen"};
  gl::FullScreen triangle_;
  std::unique_ptr<gl::Target> picture_;  // from the first that gives way on
};

}  // namespace terrella
