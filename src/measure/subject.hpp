// A renderer that sits for its measurements: it draws as a window would, and its pictures, times and work are taken.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "gl/target.hpp"
#include "measure/picture_error.hpp"
#include "measure/stopwatch.hpp"
#include "render/renderer.hpp"

namespace terrella {

class Subject {
 public:
  // Of pictures shown at this size, pixels. Needs a current context that can draw to 32 bit floats.
  Subject(int width, int height);

  // From now on draws this scene: its picture at the moment of judged_at, with all that it needs made at once.
  Image pose(const Scene& scene);
  // What that picture shows of the surface, at the size it is drawn at or, if that is less, twice the size shown.
  DrawnGeometry geometry();

  // Milliseconds of one frame more, while the clock runs: drawn, and shown on a screen of its size.
  double frame(Stopwatch& stopwatch);

  // Of the last frame, and what this renderer alone holds; in the order of counters().
  [[nodiscard]] std::vector<double> work() const;

 private:
  // Counts what is allocated as long as it lives to a subject.
  class Weighing;

  // Of the pixels drawn, at most so many along a side for each one shown.
  [[nodiscard]] View view(double largest = std::numeric_limits<double>::infinity()) const;

  int width_, height_;
  gl::Target screen_;
  Scene scene_;
  double seconds_ = 0.0;
  std::int64_t held_ = 0;  // bytes
  Renderer renderer_;
};

}  // namespace terrella
