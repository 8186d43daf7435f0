// A picture that is drawn band by band, a few at a time, so that whoever asks for frames can do other things in
// between.
#pragma once

#include <optional>

#include "app/slices.hpp"
#include "gl/fence.hpp"
#include "render/renderer.hpp"

namespace terrella {

class PictureInBands {
 public:
  // Begun, and neither finished nor dropped.
  [[nodiscard]] bool under_way() const { return next_ >= 0; }
  // All of it is drawn.
  [[nodiscard]] bool complete() const { return next_ == slices_.count(); }
  // Of each picture, 1 where pictures are drawn whole.
  [[nodiscard]] int bands() const { return slices_.count(); }

  // Draws the first band. after: how long (ms) after the picture before this one, 0 if there was a rest.
  void begin(Renderer& renderer, const Scene& scene, const View& view, const Shot& shot, double after);
  // Whether the GPU has enough to do for now; to give it more would only make it answer later.
  [[nodiscard]] bool gpu_is_busy() const;
  // Needs under_way and not complete.
  void draw_next(Renderer& renderer);
  // It was shown, or is not wanted any more.
  void drop();

  // Also what the GPU was given: its context is gone.
  void context_lost();

 private:
  template <class Draw>
  void draw_timed(Renderer& renderer, const Draw& draw);
  void draw_band(Renderer& renderer);

  Slices slices_;
  int next_ = -1;                                             // band of the picture under way
  int height_ = 0;                                            // of it, pixels
  std::optional<gl::Fence> behind_last_, behind_one_before_;  // bands that the GPU was given
};

}  // namespace terrella
