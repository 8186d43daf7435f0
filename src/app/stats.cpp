#include "app/stats.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

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

std::string to_json(const StatsReport& report) {
  using Json = nlohmann::ordered_json;
  const auto json_of = [](const Spread& spread) {
    return Json{{"median", spread.median}, {"p10", spread.p10}, {"p90", spread.p90}};
  };
  Json json;
  json["renderer"] = report.renderer;
  json["size"] = {report.width, report.height};
  json["frame_ms"] = json_of(spread_of(report.frame_ms));
  json["picture_ms"] = json_of(spread_of(report.picture_ms.empty() ? report.frame_ms : report.picture_ms));
  json["first_frame_ms"] = report.first_frame_ms;
  json["frames"] = report.frames;
  json["bands"] = report.bands;
  json["triangles"] = report.work.triangles;
  json["draw_calls"] = report.work.draw_calls;
  json["noise_evaluations"] = report.work.noise_evaluations;
  json["gpu_bytes"] = report.work.gpu_bytes;
  json["programs"] = report.work.programs;
  json["textures"] = report.work.textures;
  const Needs& needs = report.needs;
  json["slots"] = {{"ground", name_of(needs.ground)},
                   {"water", name_of(needs.water)},
                   {"clouds", name_of(needs.clouds)},
                   {"air", name_of(needs.air)},
                   {"stars", name_of(needs.stars)}};
  Json decisions = Json::array();
  for (const Decision& d : needs.decisions)
    decisions.push_back({{"what", d.what}, {"chosen", d.chosen}, {"why", d.why}});
  json["needs"] = decisions;
  if (report.quality != nullptr) {
    const std::ptrdiff_t step = report.quality - quality_path().data();
    json["quality"] = {{"step", step},
                       {"steps", quality_path().size()},
                       {"psnr", report.quality->psnr},
                       {"visible", report.quality->visible}};
  }
  json["nonfinite_pixels"] = report.nonfinite_pixels;
  json["issues"] = report.issues;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace terrella
