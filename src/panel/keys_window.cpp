#include "panel/keys_window.hpp"

#include <imgui.h>

#include <algorithm>
#include <vector>

#include "panel/finger_scroll.hpp"
#include "panel/keys.hpp"
#include "panel/widgets.hpp"

namespace terrella {
namespace {

constexpr float column = 440.0F;  // points, at the most
constexpr float most_of_display = 0.92F;
constexpr float keys_share = 0.45F;  // of the width
constexpr float line_gap = 3.0F;     // points; the whole list fits on a screen of 720

// Side by side, all of them fit on a screen that is wide; fingers need one.
int columns() { return !by_finger() && most_of_display * ImGui::GetIO().DisplaySize.x > points(2.0F * column) ? 2 : 1; }

bool begin_in_the_middle() {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float width = std::min(points(column) * static_cast<float>(columns()), most_of_display * display.x);
  ImGui::SetNextWindowPos({display.x * 0.5F, display.y * 0.5F}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, most_of_display * display.y});
  // It may lie over the panel.
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, ImGui::GetStyle().PopupBorderSize);
  const bool visible = ImGui::Begin("keys", nullptr,
                                    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  return visible;
}

void heading(Sheet& sheet) {
  const float side = ImGui::GetFrameHeight();
  const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(by_finger() ? "Fingers" : "Keys and mouse");
  ImGui::SameLine(right - side, 0.0F);
  if (ImGui::Button("x", {side, 0.0F})) sheet.memory.keys_shown = false;
  sheet.place("keys/close");
}

void lines_of(const KeyGroup& group) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, points(line_gap)});
  ImGui::SeparatorText(std::string(group.title).c_str());
  for (const KeyLine& line : group.lines) {
    two_columns(
        keys_share, [&] { ImGui::TextWrapped("%s", std::string(line.keys).c_str()); },
        [&] { quiet_text(std::string(line.does)); });
  }
  ImGui::PopStyleVar();
}

// Those of the camera come first and are as many as all others.
void groups_side_by_side() {
  // Who points by finger has no use for the others, and the other way round.
  std::vector<const KeyGroup*> groups;
  for (const KeyGroup& group : key_groups()) {
    if (group.of_fingers == by_finger()) groups.push_back(&group);
  }
  const auto count = static_cast<std::size_t>(columns());
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width =
      (ImGui::GetContentRegionAvail().x - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
  for (std::size_t side = 0; side < count; ++side) {
    if (side > 0) ImGui::SameLine();
    ImGui::BeginChild(static_cast<ImGuiID>(1 + side), {width, 0.0F}, ImGuiChildFlags_AutoResizeY);
    for (std::size_t i = side * groups.size() / count; i < (side + 1) * groups.size() / count; ++i)
      lines_of(*groups[i]);
    ImGui::EndChild();
  }
}

}  // namespace

void keys_window(Sheet& sheet) {
  bool& shown = sheet.memory.keys_shown;
  if (!shown) return;
  if (begin_in_the_middle()) {
    heading(sheet);
    groups_side_by_side();
  }
  ImGui::End();
  if (!ImGui::IsAnyItemActive() && ImGui::IsKeyPressed(ImGuiKey_Escape, false)) shown = false;
}

}  // namespace terrella
