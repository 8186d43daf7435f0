#include "panel/sections.hpp"

#include <imgui.h>

#include "base/text.hpp"

namespace terrella {

bool section_header(const Sheet& sheet, std::string_view name, std::string_view title) {
  auto& open_ones = sheet.memory.open;
  ImGui::SetNextItemOpen(open_ones.contains(name));
  const bool open = ImGui::CollapsingHeader(text_of(title, "###", name).c_str(), ImGuiTreeNodeFlags_AllowOverlap);
  sheet.place(name);
  if (open) {
    open_ones.insert(name);
  } else {
    open_ones.erase(name);
  }
  return open;
}

}  // namespace terrella
