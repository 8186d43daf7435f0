#include "panel/preset_combo.hpp"

#include <imgui.h>

#include "base/text.hpp"
#include "panel/widgets.hpp"

namespace terrella {

const Preset* preset_combo(const Sheet& sheet, std::string_view name, const Preset& chosen, const std::string& help,
                           float width) {
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo(text_of("##", name).c_str(), chosen.title.c_str(), ImGuiComboFlags_HeightLargest);
  sheet.place(name);
  if (!open) {
    tooltip(help);
    return nullptr;
  }
  const Preset* picked = nullptr;
  for (const Preset& preset : presets()) {
    if (choice_row(preset.title, &preset == &chosen)) picked = &preset;
    sheet.place(text_of(name, '/'), preset.name);
    tooltip(text_of(preset.about, '.'));
  }
  ImGui::EndCombo();
  return picked;
}

}  // namespace terrella
