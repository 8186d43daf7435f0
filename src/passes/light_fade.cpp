#include "passes/light_fade.hpp"

#include "passes/light_target.hpp"

namespace terrella {

void LightFade::begin(const gl::Image& other) {
  begin_light_target(picture_, other.width(), other.height(), other.format(), 0.0F);
}

void LightFade::blend(const gl::Target& other, double part) {
  other.begin();
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendColor(0.0F, 0.0F, 0.0F, static_cast<float>(part));
  glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
  picture_->image().bind(gl::unit_image);
  program_.use();
  program_.set("corner", 0.0F, 0.0F);
  triangle_.draw();
}

}  // namespace terrella
