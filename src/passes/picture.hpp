// From light to the screen: tone, sRGB, smooth edges.
#pragma once

#include <memory>

#include "gl/mesh.hpp"
#include "gl/program.hpp"
#include "gl/target.hpp"
#include "planet/pose.hpp"

namespace terrella {

class PicturePass {
 public:
  bool ready() { return tone_.ready() && antialias_.ready(); }

  // Makes the finished picture from light, at the light's size.
  void develop(const gl::Image& light);

  // Shows the finished picture on the whole of a framebuffer, scaled to it. smooth: the part of it in which edges are
  // smoothed, if any. Needs develop once.
  void show(const gl::Screen& screen, const PictureBox* smooth);

 private:
  gl::Program tone_{"picture/tone", "picture/screen"};
  gl::Program antialias_{"picture/antialias", "picture/screen"};
  gl::FullScreen triangle_;
  std::unique_ptr<gl::Target> developed_;
};

}  // namespace terrella
