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

  // The light has changed since it was last shown.
  void light_changed() {
    developed_part_ = {};
    reduced_now_ = false;
  }

  // Shows light as a picture on the whole of a framebuffer, scaled to it; of more light than pixels, each shows the
  // mean. smooth: the part of it in which edges are smoothed, if any; not in the first pictures, unless it is patient,
  // nor where four samples or more make a pixel.
  void show(const gl::Image& light, const gl::Screen& screen, const PictureBox* smooth, bool patient);

  // Whether the last picture was shown as smooth as it was to be.
  [[nodiscard]] bool settled() const { return settled_; }

 private:
  // Light of as many pixels as a screen has, made from more.
  const gl::Image& reduced(const gl::Image& light, const gl::Screen& screen);
  // Makes a part of the finished picture, at the light's size, unless it is there.
  void develop(const gl::Image& light, const gl::Pixels& part);
  // Draws to all of a picture but a part.
  void draw_around(const gl::Pixels& hole, int width, int height);

  gl::Program tone_{"picture/tone", "picture/screen"};
  gl::LateProgram antialias_{"picture/antialias", "picture/screen"};
  std::unique_ptr<gl::Program> reduce_;  // where more pixels are drawn than are shown, from the first such picture on
  gl::FullScreen triangle_;
  std::unique_ptr<gl::Target> developed_;  // where it is to be scaled or smoothed
  gl::Pixels developed_part_;
  std::unique_ptr<gl::Target> reduced_;
  bool reduced_now_ = false;  // holds the mean of the light as it is
  bool settled_ = true;
};

}  // namespace terrella
