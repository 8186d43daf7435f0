#include "measure/stopwatch.hpp"

#include <chrono>

#include "base/milliseconds.hpp"

namespace terrella {

Stopwatch::Stopwatch() {
  if (gl::has_timer()) timer_.emplace();
}

double Stopwatch::time(const std::function<void()>& draw) {
  constexpr int most_tries = 10;
  for (int i = 0; timer_ && i < most_tries; ++i) {
    timer_->begin();
    draw();
    if (const std::optional<double> time = timer_->end()) return *time;
  }
  glFinish();
  const auto start = std::chrono::steady_clock::now();
  draw();
  glFinish();
  return milliseconds_since(start);
}

}  // namespace terrella
