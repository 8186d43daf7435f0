#include "passes/light_fade.hpp"

namespace terrella {

void LightFade::begin(const gl::Image& other) {
  const gl::Image* image = picture_ ? &picture_->image() : nullptr;
  if (image == nullptr || image->width() != other.width() || image->height() != other.height() ||
      image->format() != other.format()) {
    picture_.reset();
    picture_ = std::make_unique<gl::Target>(other.width(), other.height(), other.format(), true);
  }
  picture_->begin();
  const float empty_sky[] = {0.0F, 0.0F, 0.0F, 0.0F};
  const float farthest = 0.0F;
  glDepthMask(GL_TRUE);
  glClearBufferfv(GL_COLOR, 0, empty_sky);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
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
