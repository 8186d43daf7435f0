#include "panel/search_field.hpp"

#include <imgui.h>

#include "panel/keyboard.hpp"
#include "panel/widgets.hpp"

namespace terrella {

void search_field(Sheet& sheet) {
  Search& search = sheet.memory.search;
  const bool filled = search.text[0] != '\0';
  const float button = ImGui::GetFrameHeight(), space = ImGui::GetStyle().ItemSpacing.x;
  const bool can_focus = !ImGui::IsWindowAppearing();  // a request now would be lost
  if (search.wanted && can_focus) focus_next_widget();
  if (can_focus) search.wanted = false;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - (filled ? button + space : 0.0F));
  ImGui::InputTextWithHint("##search", "Search  /", search.text.data(), search.text.size(),
                           ImGuiInputTextFlags_AutoSelectAll);
  sheet.place("search");
  // Elsewhere Escape belongs to whoever has the keyboard.
  const bool mine = ImGui::IsItemDeactivated() || !(sheet.memory.keys_shown || ImGui::IsAnyItemActive());
  bool clear = mine && ImGui::IsKeyPressed(ImGuiKey_Escape, false);
  tooltip("Shows the parameters in whose name or description all these words occur (/). Escape clears it.");
  if (filled) {
    ImGui::SameLine();
    if (ImGui::Button("x##clear_search", {button, 0.0F})) clear = true;
    sheet.place("search/clear");
    tooltip("Shows all parameters again (Escape).");
  }
  if (clear) search.text = {};
}

}  // namespace terrella
