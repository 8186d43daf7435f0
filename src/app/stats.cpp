#include "app/stats.hpp"

#include <algorithm>
#include <cmath>

#include "base/json_text.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"

namespace terrella {

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, values.size() - 1);
    return std::lerp(values[low], values[high], place - static_cast<double>(low));
  };
  return {at(0.5), at(0.1), at(0.9)};
}

namespace {

std::string json_of(const Spread& spread) {
  return json_object({{"median", text_of(spread.median)}, {"p10", text_of(spread.p10)}, {"p90", text_of(spread.p90)}});
}

std::string slots_of(const Needs& needs) {
  const auto quoted = [](std::string_view name) { return json_quoted(name); };
  return json_object({{"ground", quoted(name_of(needs.ground))},
                      {"water", quoted(name_of(needs.water))},
                      {"clouds", quoted(name_of(needs.clouds))},
                      {"air", quoted(name_of(needs.air))},
                      {"stars", quoted(name_of(needs.stars))}});
}

std::string decisions_of(const Needs& needs) {
  std::vector<std::string> decisions;
  for (const Decision& d : needs.decisions) {
    decisions.push_back(
        json_object({{"what", json_quoted(d.what)}, {"chosen", json_quoted(d.chosen)}, {"why", json_quoted(d.why)}}));
  }
  return json_list(decisions);
}

// Nothing for none.
std::string quality_of(const QualityStep* step) {
  if (step == nullptr) return {};
  return json_object({{"step", text_of(step - quality_path().data())},
                      {"steps", text_of(quality_path().size())},
                      {"psnr", text_of(step->psnr)},
                      {"visible", text_of(step->visible)}});
}

}  // namespace

// Without a library, which would be 2 kB of the page's download.
std::string to_json(const StatsReport& report) {
  const RenderStats& work = report.work;
  const std::vector<double>& pictures = report.picture_ms.empty() ? report.frame_ms : report.picture_ms;
  return json_object({{"renderer", json_quoted(repaired_utf8(report.renderer))},
                      {"size", json_list({text_of(report.width), text_of(report.height)})},
                      {"frame_ms", json_of(spread_of(report.frame_ms))},
                      {"picture_ms", json_of(spread_of(pictures))},
                      {"first_frame_ms", text_of(report.first_frame_ms)},
                      {"frames", text_of(report.frames)},
                      {"bands", text_of(report.bands)},
                      {"triangles", text_of(work.triangles)},
                      {"draw_calls", text_of(work.draw_calls)},
                      {"noise_evaluations", text_of(work.noise_evaluations)},
                      {"gpu_bytes", text_of(work.gpu_bytes)},
                      {"programs", json_texts(work.programs)},
                      {"textures", text_of(work.textures)},
                      {"slots", slots_of(report.needs)},
                      {"needs", decisions_of(report.needs)},
                      {"quality", quality_of(report.quality)},
                      {"nonfinite_pixels", text_of(report.nonfinite_pixels)},
                      {"issues", json_texts(report.issues)}});
}

}  // namespace terrella
