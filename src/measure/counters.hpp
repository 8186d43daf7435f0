// The work of a frame that is counted: a line each.
#pragma once

#include <span>
#include <vector>

#include "render/renderer.hpp"

namespace terrella {

struct Counter {
  const char* name;   // in report.json: "noise_evaluations"
  const char* title;  // of a column
  double unit;        // in which a column tells it: 1e6 for megabytes
  double (*of)(const RenderStats& stats);
};

std::span<const Counter> counters();

// In the order of counters().
std::vector<double> counted(const RenderStats& stats);

}  // namespace terrella
