#include "app/picture_in_bands.hpp"

#include <chrono>

namespace terrella {
namespace {

// So that the GPU has the next band at hand when it is done with one.
constexpr std::size_t bands_ahead = 2;

}  // namespace

template <class Draw>
void PictureInBands::draw_timed(Renderer& renderer, const Draw& draw) {
  if (slices_.wants_time_of(next_)) {
    using Clock = std::chrono::steady_clock;
    renderer.wait();
    const Clock::time_point start = Clock::now();
    draw();
    renderer.wait();
    slices_.took(next_, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  } else {
    draw();
  }
  if (slices_.count() > 1) fences_.emplace_back();
  ++next_;
}

void PictureInBands::begin(Renderer& renderer, const Scene& scene, const View& view, const Shot& shot, double after) {
  if (slices_.count() == 1) slices_.whole_came_after(after);
  height_ = view.height;
  next_ = 0;
  // What is done once a picture counts as a part of the first band, which so comes to have fewer rows.
  draw_timed(renderer, [&] {
    renderer.begin(scene, view, shot);
    draw_band(renderer);
  });
}

void PictureInBands::draw_next(Renderer& renderer) {
  draw_timed(renderer, [&] { draw_band(renderer); });
}

void PictureInBands::draw_band(Renderer& renderer) {
  const auto [first, end] = slices_.band(next_);
  renderer.draw_rows({height_ * first / Slices::strips, height_ * end / Slices::strips});
}

bool PictureInBands::gpu_is_busy() {
  while (!fences_.empty() && fences_.front().passed()) fences_.pop_front();
  return fences_.size() >= bands_ahead;
}

void PictureInBands::drop() {
  if (under_way() && complete()) slices_.decide();
  next_ = -1;
}

void PictureInBands::context_lost() {
  fences_.clear();
  next_ = -1;
}

}  // namespace terrella
