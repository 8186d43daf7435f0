#include "panel/quality_rows.hpp"

#include <imgui.h>

#include <cmath>
#include <string>

#include "base/text.hpp"
#include "panel/parameter_row.hpp"
#include "panel/quantity.hpp"
#include "panel/widgets.hpp"
#include "scene/quality_path.hpp"

namespace terrella {
namespace {

constexpr double automatic_ms = 33.0;  // 30 pictures a second: more is not worth coarser ones

// "29 dB, 25 % of it visibly off"
std::string how_wrong(const QualityStep& step) {
  return text_of(std::lround(step.psnr), " dB, ", std::lround(100.0 * step.visible), " % of it visibly off");
}

std::string chosen(const Scene& scene) {
  if (holds_time(scene)) return "automatic";
  for (const QualityStep& step : quality_path()) {
    if (!step.preset.empty() && has_quality(scene, step)) return std::string(step.preset);
  }
  return "as set below";
}

void set_quality(Sheet& sheet, const QualityStep& step) {
  const Scene scene = with_quality(sheet.document.scene, step);
  for (const Parameter& parameter : parameters()) {
    if (parameter.group == "quality") sheet.set(parameter, parameter.get(scene));
  }
  sheet.set(*find_parameter("quality.target_ms"), 0.0);
}

void preset_list(Sheet& sheet) {
  const Scene& scene = sheet.document.scene;
  const std::string now = chosen(scene);
  ImGui::SetNextItemWidth(row_label("Preset"));
  const bool open = ImGui::BeginCombo("##quality_preset", now.c_str());
  sheet.place("quality/preset");
  if (!open) return tooltip("Settings that are worth their time, as measured with the default planet.");
  if (choice_row("automatic", now == "automatic")) sheet.set(*find_parameter("quality.target_ms"), automatic_ms);
  sheet.place("quality/preset/automatic");
  tooltip(text_of("As fine as ", automatic_ms, " ms a frame allow, and at its finest where the planet rests."));
  for (const QualityStep& step : quality_path()) {
    if (step.preset.empty()) continue;
    const std::string name(step.preset);
    if (choice_row(name, now == name)) set_quality(sheet, step);
    sheet.place("quality/preset/", name);
    tooltip(text_of(how_wrong(step), '.'));
  }
  ImGui::EndCombo();
}

// "resolution scale 0.7 (2), antialias false (true)"
std::string given_up(const QualityStep& step, const QualityStep& best) {
  const Scene drawn = with_quality({}, step), finest = with_quality({}, best);
  std::string list;
  for (const Parameter& parameter : parameters()) {
    const Value value = parameter.get(drawn), better = parameter.get(finest);
    if (value == better) continue;
    list +=
        text_of(list.empty() ? "" : ", ", in_words(parameter.name), ' ', to_text(value), " (", to_text(better), ')');
  }
  return list;
}

void held_quality(const Sheet& sheet, const QualityStep& step) {
  const QualityStep& best = quality_path().back();
  const auto number = &step - quality_path().data() + 1;
  const std::string place = text_of("Step ", number, " of ", quality_path().size(), ", about ", how_wrong(step), ". ");
  const std::string lost =
      &step == &best ? std::string("Nothing is given up.") : text_of("Given up: ", given_up(step, best), '.');
  quiet_text(text_of("Holding ", short_number(sheet.document.scene.quality.target_ms), " ms. ", place, lost,
                     " The settings below wait until target ms is 0."));
}

}  // namespace

void quality_rows(Sheet& sheet) {
  preset_list(sheet);
  if (sheet.facts.quality != nullptr) held_quality(sheet, *sheet.facts.quality);
}

}  // namespace terrella
