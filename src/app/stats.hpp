// What a session says of its work: the program's --stats and the page's stats().
#pragma once

#include <string>
#include <vector>

#include "base/issues.hpp"
#include "render/renderer.hpp"
#include "scene/quality_path.hpp"

namespace terrella {

struct StatsReport {
  std::string renderer;
  int width = 0, height = 0;
  std::vector<double> frame_ms;    // of each timed frame; may be empty
  std::vector<double> picture_ms;  // from one picture on screen to the next, likewise; empty where each frame is one
  double first_frame_ms = 0.0;
  std::int64_t frames = 0;  // pictures shown
  int bands = 1;            // frames that a picture is drawn in, beside the one that shows it
  RenderStats work;
  Needs needs;
  std::int64_t nonfinite_pixels = 0;
  std::vector<std::string> issues;
  const QualityStep* quality = nullptr;  // at which the last frame was drawn, where quality.target_ms is held
};

// JSON on one line; its members are those of the command line manual (docs/command_line.md).
std::string to_json(const StatsReport& report);

// Median and the 10th and 90th of a hundred, 0 for none.
struct Spread {
  double median = 0.0, p10 = 0.0, p90 = 0.0;
};
Spread spread_of(std::vector<double> values);

}  // namespace terrella
