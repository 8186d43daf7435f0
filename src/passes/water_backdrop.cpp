#include "passes/water_backdrop.hpp"

#include "gl/caps.hpp"
#include "planet/pose.hpp"

namespace terrella {

void WaterBackdrop::draw(const Frame& frame) {
  program_.use();
  program_.set("nearness", static_cast<float>(depth_scheme(frame.pose, gl::caps().clip_control).far_plane));
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_ALWAYS);
  triangle_.draw();
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
}

void WaterBackdrop::close() {
  program_.use();
  program_.set("nearness", 1.0F);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthFunc(GL_ALWAYS);
  triangle_.draw();
  glDepthFunc(GL_GREATER);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace terrella
