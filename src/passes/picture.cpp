#include "passes/picture.hpp"

#include <algorithm>
#include <cmath>

namespace terrella {
namespace {

// How far from a pixel its smooth colour is looked for (antialias.frag), rounded up.
constexpr int reach = 6;
// The sky next to the planet is smoothed as well.
constexpr int edge = 1;

// What a box covers of a picture of some width and height, with a margin around it.
gl::Pixels pixels_of(const PictureBox& box, int width, int height, int margin) {
  const auto at = [](double part, int all, int outward) {
    return std::clamp(static_cast<int>(std::lround(part * all)) + outward, 0, all);
  };
  const int left = at(box.left, width, -margin), bottom = at(box.bottom, height, -margin);
  return {left, bottom, at(box.right, width, margin) - left, at(box.top, height, margin) - bottom};
}

}  // namespace

void PicturePass::show(const gl::Image& drawn, const gl::Screen& screen, const PictureBox* box, bool patient) {
  // A mean of four samples or more is smooth: to smooth it further would blur it.
  const bool fine = drawn.width() >= 2 * screen.width && drawn.height() >= 2 * screen.height;
  const PictureBox* smooth = fine ? nullptr : box;
  const bool more = drawn.width() > screen.width || drawn.height() > screen.height;
  const gl::Image& light = more ? reduced(drawn, screen) : drawn;
  if (!more) reduced_.reset();
  settled_ = smooth == nullptr || antialias_.ready(patient);
  const bool smoothing = smooth != nullptr && settled_;
  const bool scaled = light.width() != screen.width || light.height() != screen.height;
  const gl::Pixels smoothed = smoothing ? pixels_of(*smooth, screen.width, screen.height, edge) : gl::Pixels{};
  if (scaled) {
    develop(light, {0, 0, light.width(), light.height()});
    gl::copy(*developed_, screen);
  } else {
    if (smoothing) develop(light, pixels_of(*smooth, screen.width, screen.height, edge + reach));
    screen.begin();
    light.bind(gl::unit_image);
    tone_.use();
    draw_around(smoothed, screen.width, screen.height);
  }
  if (!smoothing) return;
  const gl::Image& image = developed_->image();
  screen.begin();
  const gl::Scissors scissors(smoothed);
  image.bind(gl::unit_image);
  antialias_->use();
  antialias_->set("texel", 1.0F / static_cast<float>(image.width()), 1.0F / static_cast<float>(image.height()));
  triangle_.draw();
}

const gl::Image& PicturePass::reduced(const gl::Image& light, const gl::Screen& screen) {
  const bool fits = reduced_ && reduced_->image().width() == screen.width &&
                    reduced_->image().height() == screen.height && reduced_->image().format() == light.format();
  if (fits && reduced_now_) return reduced_->image();
  if (!fits) {
    reduced_.reset();
    reduced_ = std::make_unique<gl::Target>(screen.width, screen.height, light.format(), gl::Depth::none);
  }
  if (!reduce_) reduce_ = std::make_unique<gl::Program>("picture/reduce", "picture/screen");
  reduced_->begin();
  light.bind(gl::unit_image);
  reduce_->use();
  reduce_->set("samples", static_cast<float>(light.width()) / static_cast<float>(screen.width),
               static_cast<float>(light.height()) / static_cast<float>(screen.height));
  triangle_.draw();
  reduced_now_ = true;
  developed_part_ = {};
  return reduced_->image();
}

void PicturePass::develop(const gl::Image& light, const gl::Pixels& part) {
  if (part == developed_part_) return;
  if (!developed_ || developed_->image().width() != light.width() || developed_->image().height() != light.height()) {
    developed_.reset();
    developed_ = std::make_unique<gl::Target>(light.width(), light.height(), gl::Format::rgba8, gl::Depth::none);
  }
  developed_->begin();
  light.bind(gl::unit_image);
  tone_.use();
  const gl::Scissors scissors(part);
  triangle_.draw();
  developed_part_ = part;
}

void PicturePass::draw_around(const gl::Pixels& hole, int width, int height) {
  const int right = hole.left + hole.width, top = hole.bottom + hole.height;
  for (const gl::Pixels& part : {gl::Pixels{0, 0, width, hole.bottom}, gl::Pixels{0, top, width, height - top},
                                 gl::Pixels{0, hole.bottom, hole.left, hole.height},
                                 gl::Pixels{right, hole.bottom, width - right, hole.height}}) {
    if (part.width <= 0 || part.height <= 0) continue;
    const gl::Scissors scissors(part);
    triangle_.draw();
  }
}

}  // namespace terrella
