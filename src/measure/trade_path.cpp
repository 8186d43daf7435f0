#include "measure/trade_path.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "measure/words.hpp"
#include "scene/quality_path.hpp"

namespace terrella {
namespace {

constexpr double well_apart = 1.2;  // times the time of a frame

std::string preset_of(std::size_t setting, const TradeReport& report) {
  for (const QualityPreset& preset : report.presets) {
    if (preset.setting == setting) return preset.name;
  }
  return {};
}

std::string row(const std::string& name, const Setting& setting, const Setting& own) {
  const PictureError error = setting.error();
  return text_of("| ", name, " | ", printed_number(setting.ms().median / own.ms().median, 2), " | ",
                 printed_number(error.psnr(), 3), " | ", percent(error.visible), " | ", printed_number(error.flip, 2),
                 " |\n");
}

}  // namespace

std::vector<std::size_t> walked_settings(const TradeReport& report) {
  const auto ms = [&](std::size_t i) { return report.settings[i].ms().median; };
  std::vector<std::size_t> steps;
  for (const QualityPreset& preset : report.presets) steps.push_back(preset.setting);
  for (const std::size_t i : report.path) {
    const auto near = [&](std::size_t other) {
      return std::max(ms(i), ms(other)) < well_apart * std::min(ms(i), ms(other));
    };
    if (std::none_of(steps.begin(), steps.end(), near)) steps.push_back(i);
  }
  std::sort(steps.begin(), steps.end(), [&](std::size_t a, std::size_t b) { return ms(a) < ms(b); });
  return steps;
}

std::string path_inc(const TradeReport& report) {
  std::string text = text_of(
      "// The path of quality, from the cheapest step to the most accurate: path.inc of `terrella measure`. ",
      "Measured by ", report.machine.renderer, " at ", report.plan.width, "x", report.plan.height, ", from ",
      report.cameras.size(), " cameras, with the preset ", report.document.preset, ".\n",
      "// STEP(name as a preset of quality or \"\", time of a frame as a multiple of the first step's, dB against the ",
      "reference,\n", "// part of the pixels visibly off, what differs from the program's defaults)\n");
  const std::vector<std::size_t> steps = walked_settings(report);
  for (const std::size_t i : steps) {
    const Setting& setting = report.settings[i];
    const double cost = setting.ms().median / report.settings[steps.front()].ms().median;
    const PictureError error = setting.error();
    text += text_of("STEP(\"", preset_of(i, report), "\", ", printed_number(cost, 3), ", ",
                    printed_number(error.psnr(), 3), ", ", printed_number(error.visible, 2), ",\n     \"",
                    setting.id == "default" ? "" : setting.id, "\")\n");
  }
  return text;
}

std::string path_table(const TradeReport& report) {
  const Setting& own = report.settings[report.own];
  std::string text = "| quality | time | dB | visibly off | FLIP |\n| --- | --- | --- | --- | --- |\n";
  text += row("the scene's own", own, own);
  for (std::size_t i = 0; i < report.steps.size(); ++i) {
    const std::string_view preset = quality_path()[i].preset;
    text += row(preset.empty() ? text_of("step ", i + 1) : std::string(preset), report.settings[report.steps[i]], own);
  }
  if (report.steps.empty()) {
    for (const QualityPreset& preset : report.presets) text += row(preset.name, report.settings[preset.setting], own);
  }
  return text;
}

}  // namespace terrella
