#include "app/picture_in_bands.hpp"

#include <chrono>
#include <utility>

namespace terrella {
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
  if (slices_.count() > 1) {
    behind_one_before_ = std::exchange(behind_last_, std::nullopt);
    behind_last_.emplace();
  }
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

// Not before it is at the last of what it was given, so that it has the next at hand when it is done with that.
bool PictureInBands::gpu_is_busy() const { return behind_one_before_ && !behind_one_before_->passed(); }

void PictureInBands::drop() {
  if (under_way() && complete()) slices_.decide();
  next_ = -1;
}

void PictureInBands::context_lost() {
  behind_last_.reset();
  behind_one_before_.reset();
  next_ = -1;
}

}  // namespace terrella
