// How long drawing takes.
#pragma once

#include <functional>
#include <optional>

#include "gl/timer.hpp"

namespace terrella {

class Stopwatch {
 public:
  // Needs a current context.
  Stopwatch();

  // Milliseconds: those of the GPU's own clock where it has one to be trusted, else from the call until all that was
  // drawn is there. Draws again where the GPU's clock was disturbed.
  double time(const std::function<void()>& draw);

  [[nodiscard]] bool of_the_gpu() const { return timer_.has_value(); }

 private:
  std::optional<gl::Timer> timer_;
};

}  // namespace terrella
