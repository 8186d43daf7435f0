#include "panel/preset_combo.hpp"

#include <imgui.h>

#include "base/text.hpp"
#include "panel/widgets.hpp"

namespace terrella {
const Preset* preset_combo(Sheet& sheet, std::string_view name, const Preset& chosen, const std::string& title,
                           const std::string& help, float width) {
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo(text_of("##", name).c_str(), title.c_str(), ImGuiComboFlags_HeightLargest);
  sheet.place(name);
  if (!open) {
    tooltip(help);
    return nullptr;
  }
  sheet.memory.presets_shown = true;
  const std::vector<unsigned>& pictures = sheet.facts.preset_pictures;
  const Preset* picked = nullptr;
  for (std::size_t i = 0; i < presets().size(); ++i) {
    const Preset& preset = presets()[i];
    if (picture_row(preset.title, i < pictures.size() ? pictures[i] : 0, &preset == &chosen)) picked = &preset;
    sheet.place(text_of(name, '/'), preset.name);
    tooltip(text_of(preset.about, '.'));
  }
  ImGui::EndCombo();
  return picked;
}

}  // namespace terrella
