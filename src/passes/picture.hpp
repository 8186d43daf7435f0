// From light to the screen: tone, sRGB, smooth edges.
#pragma once

#include <memory>

#include "gl/late_program.hpp"
#include "gl/mesh.hpp"
#include "gl/program.hpp"
#include "gl/target.hpp"
#include "planet/pose.hpp"

namespace terrella {

class PicturePass {
 public:
  bool ready() { return tone_.ready(); }

  // Makes the finished picture from light, at the light's size.
  void develop(const gl::Image& light);

  // Shows the finished picture on the whole of a framebuffer, scaled to it. smooth: the part of it in which edges are
  // smoothed, if any; not in the first pictures, unless it is patient. Needs develop once.
  void show(const gl::Screen& screen, const PictureBox* smooth, bool patient);

  // Whether the last picture was shown as smooth as it was to be.
  [[nodiscard]] bool settled() const { return settled_; }

 private:
  gl::Program tone_{"picture/tone", "picture/screen"};
  gl::LateProgram antialias_{"picture/antialias", "picture/screen"};
  gl::FullScreen triangle_;
  std::unique_ptr<gl::Target> developed_;
  bool settled_ = true;
};

}  // namespace terrella
