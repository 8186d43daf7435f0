#include "passes/picture.hpp"

#include <cmath>

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

void PicturePass::show(const gl::Screen& screen, const PictureBox* smooth, bool patient) {
  gl::copy(*developed_, screen);
  settled_ = smooth == nullptr || antialias_.ready(patient);
  if (smooth == nullptr || !settled_) return;
  const gl::Image& image = developed_->image();
  const auto pixel = [](double part, int all) { return static_cast<int>(std::lround(part * all)); };
  const int left = pixel(smooth->left, screen.width) - 1, bottom = pixel(smooth->bottom, screen.height) - 1;
  screen.begin();
  const gl::Scissors scissors(left, bottom, pixel(smooth->right, screen.width) + 1 - left,
                              pixel(smooth->top, screen.height) + 1 - bottom);
  image.bind(gl::unit_image);
  antialias_->use();
  antialias_->set("texel", 1.0F / static_cast<float>(image.width()), 1.0F / static_cast<float>(image.height()));
  triangle_.draw();
}

}  // namespace terrella
