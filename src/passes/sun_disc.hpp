// The sun's disc behind everything, and its glare before everything.
#pragma once

#include "gl/late_program.hpp"
#include "gl/mesh.hpp"
#include "passes/frame.hpp"

namespace terrella {

class SunDisc {
 public:
  // No picture waits for its program unless it is to be complete.
  void update(const Frame& frame) { ready_ = program_.ready(frame.effort == Effort::complete); }
  void draw_disc(const Frame& frame);
  void draw_glare(const Frame& frame);
  [[nodiscard]] bool settled() const { return ready_; }

 private:
  void draw(const Frame& frame, double reach, double disc, double glare);

  gl::LateProgram program_{"sun/disc"};
  gl::Strip strip_;
  bool ready_ = false;
};

}  // namespace terrella
