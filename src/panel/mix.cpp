#include "panel/mix.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "panel/preset_combo.hpp"
#include "panel/slider_hand.hpp"
#include "panel/widgets.hpp"
#include "scene/morph.hpp"
#include "scene/view_groups.hpp"

namespace terrella {
namespace {

constexpr std::string_view slider_name = "mix/share";
constexpr double wheel_step = 0.01;
constexpr float label_share = 0.4F;  // of the width

// What the user has done since to the planet itself is a new beginning; to have looked at it otherwise is not.
void begin_anew_if_changed(Mix& mix, const Scene& scene) {
  if (mix.share == 0.0 || seen_as(mix.mixed, scene) == scene) return;
  mix.share = 0.0;
}

void mix_to(Sheet& sheet, const Preset& preset, double share) {
  Mix& mix = sheet.memory.mix;
  Scene& scene = sheet.document.scene;
  if (mix.share == 0.0) mix.from = scene;
  mix.preset = preset.name;
  mix.share = share;
  const Scene before = scene;
  scene = mix.mixed = seen_as(morph(mix.from, preset.scene, share), before);
  if (scene != before) sheet.wishes.scene_changed = true;
}

void slider(Sheet& sheet, const Preset& preset, float width) {
  const double share = sheet.memory.mix.share;
  bar("##mix_share", share, text_of(std::lround(100.0 * share), " %"), width);
  sheet.place(slider_name);
  if (ImGui::IsItemActive()) sheet.wishes.dragging = true;
  const SliderWish wish = hand_on_slider(sheet.memory.hand, slider_name, share, share);
  double wanted = wish.position.value_or(share) + wheel_step * wish.steps;
  if (wish.type) wanted = *wish.type;  // it is not typed; the first of two clicks moved it
  wanted = std::clamp(std::round(wanted * 1000.0) / 1000.0, 0.0, 1.0);
  if (wanted != share) mix_to(sheet, preset, wanted);
  tooltip("How far to go from the planet as it is to that preset. Camera, picture, time and quality stay.");
}

}  // namespace

void mix_section(Sheet& sheet) {
  Mix& mix = sheet.memory.mix;
  if (!mix.shown) return;
  begin_anew_if_changed(mix, sheet.document.scene);
  const Preset* const remembered = find_preset(mix.preset);
  const Preset& preset = remembered != nullptr ? *remembered : presets()[1];
  const float room = ImGui::GetContentRegionAvail().x, space = ImGui::GetStyle().ItemSpacing.x;
  const Preset* const picked =
      preset_combo(sheet, "mix/preset", preset, preset.title, "The preset to mix with.", label_share * room);
  if (picked != nullptr) mix_to(sheet, *picked, mix.share);
  ImGui::SameLine();
  slider(sheet, preset, (1.0F - label_share) * room - space);
}

}  // namespace terrella
