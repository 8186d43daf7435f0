#include "passes/picture.hpp"

namespace terrella {

void PicturePass::develop(const gl::Image& light) {
  if (!developed_ || developed_->image().width() != light.width() || developed_->image().height() != light.height()) {
    developed_.reset();
    developed_ = std::make_unique<gl::Target>(light.width(), light.height(), gl::Format::rgba8, false);
  }
  developed_->begin();
  light.bind(gl::unit_image);
  tone_.use();
  triangle_.draw();
}

void PicturePass::show(bool antialias) {
  const gl::Image& image = developed_->image();
  image.bind(gl::unit_image);
  antialias_.use();
  antialias_.set("texel", 1.0F / static_cast<float>(image.width()), 1.0F / static_cast<float>(image.height()));
  antialias_.set("strength", antialias ? 1.0F : 0.0F);
  triangle_.draw();
}

}  // namespace terrella
