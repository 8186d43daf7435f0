#include "app/picture_in_bands.hpp"

#include <chrono>

namespace terrella {
namespace {

// So that the GPU has the next band at hand when it is done with one.
constexpr std::size_t bands_ahead = 2;

}  // namespace

template <class Draw>
void PictureInBands::draw_timed(Renderer& renderer, int band, const Draw& draw) {
  if (!slices_.wants_time_of(band)) return draw();
  using Clock = std::chrono::steady_clock;
  renderer.wait();
  const Clock::time_point start = Clock::now();
  draw();
  renderer.wait();
  slices_.took(band, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
}

void PictureInBands::draw_whole(Renderer& renderer, const Scene& scene, const View& view, const Shot& shot,
                                double after) {
  if (slices_.count() > 1) return renderer.draw(scene, view, shot);
  slices_.whole_came_after(after);
  renderer.begin(scene, view, shot);
  draw_timed(renderer, 0, [&] { renderer.draw_rows({0, view.height}); });
  slices_.decide();
}

void PictureInBands::begin(Renderer& renderer, const Scene& scene, const View& view, const Shot& shot) {
  renderer.begin(scene, view, shot);
  height_ = view.height;
  next_ = 0;
  draw_next(renderer);
}

bool PictureInBands::gpu_is_busy() {
  while (!fences_.empty() && fences_.front().passed()) fences_.pop_front();
  return fences_.size() >= bands_ahead;
}

void PictureInBands::draw_next(Renderer& renderer) {
  const auto [first, end] = slices_.band(next_);
  const Rows rows = {height_ * first / Slices::strips, height_ * end / Slices::strips};
  draw_timed(renderer, next_, [&] { renderer.draw_rows(rows); });
  fences_.emplace_back();
  ++next_;
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
