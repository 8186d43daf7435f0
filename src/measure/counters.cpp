#include "measure/counters.hpp"

namespace terrella {
namespace {

constexpr Counter all_counters[] = {
    {"triangles", "triangles", 1.0, [](const RenderStats& s) { return static_cast<double>(s.triangles); }},
    {"noise_evaluations", "noise, k", 1e3,
     [](const RenderStats& s) { return static_cast<double>(s.noise_evaluations); }},
    {"texture_reads", "reads, k", 1e3, [](const RenderStats& s) { return static_cast<double>(s.texture_reads); }},
    {"draw_calls", "draw calls", 1.0, [](const RenderStats& s) { return static_cast<double>(s.draw_calls); }},
    {"gpu_bytes", "GPU, MB", 1e6, [](const RenderStats& s) { return static_cast<double>(s.gpu_bytes); }},
};

}  // namespace

std::span<const Counter> counters() { return all_counters; }

std::vector<double> counted(const RenderStats& stats) {
  std::vector<double> values;
  for (const Counter& counter : all_counters) values.push_back(counter.of(stats));
  return values;
}

}  // namespace terrella
