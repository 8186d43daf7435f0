#include "app/map_picture.hpp"

#include "base/milliseconds.hpp"

namespace terrella {
namespace {

constexpr int width = 320, height = 160;  // pixels

}  // namespace

MapPicture::MapPicture() : image_(width, height, gl::Format::rgba16f), row_(width) {
  for (int row = 0; row < height; ++row) image_.set_row(row, row_);
}

bool MapPicture::advance(const Scene& scene, double time) {
  const Subject subject = {scene.planet, scene.terrain, scene.water};
  if (subject_ != subject) {
    subject_ = subject;
    map_.emplace(scene, height);
    left_ = height;
  }
  if (left_ == 0) return false;
  const auto start = std::chrono::steady_clock::now();
  do {
    map_->make_row(next_, row_);
    image_.set_row(next_, row_);
    next_ = (next_ + 1) % height;
  } while (--left_ > 0 && milliseconds_since(start) < time);
  return true;
}

}  // namespace terrella
