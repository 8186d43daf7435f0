#include "panel/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstdint>

#include "base/text.hpp"
#include "panel/keyboard.hpp"

namespace terrella {
namespace {

constexpr float tooltip_width = 260.0F;                         // points
constexpr float picture_width = 64.0F, picture_height = 36.0F;  // points
constexpr float bar_inset = 4.0F;                               // points, so that both ends can be hit

bool hand_is_busy() { return ImGui::IsAnyItemActive(); }

void draw_bar(ImVec2 from, ImVec2 to, double position, const std::string& text) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  const float inset = points(bar_inset);
  const float x = from.x + inset + static_cast<float>(position) * (to.x - from.x - 2.0F * inset);
  list.AddRectFilled(from, to, ImGui::GetColorU32(lit ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), rounding);
  list.AddRectFilled(from, {x, to.y}, ImGui::GetColorU32(lit ? ImGuiCol_SliderGrabActive : ImGuiCol_SliderGrab),
                     rounding, ImDrawFlags_RoundCornersLeft);
  // The bright line shows the position, and lies where it does not cross the text.
  list.AddRectFilled({from.x, to.y - points(2.0F)}, {x, to.y}, ImGui::GetColorU32(ImGuiCol_CheckMark), points(1.0F));
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 at{std::max(from.x + inset, (from.x + to.x - size.x) * 0.5F), (from.y + to.y - size.y) * 0.5F};
  const ImVec4 clip{from.x, from.y, to.x, to.y};
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {static_cast<float>(static_cast<int>(at.x)), at.y},
               ImGui::GetColorU32(ImGuiCol_Text), text.c_str(), nullptr, 0.0F, &clip);
}

// Three quarters of a circle, with a head at the end where it has come back to.
void draw_turn_back(ImVec2 centre, float radius, unsigned color) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  constexpr float start = -2.2F, end = 2.4F;  // rad, clockwise from the right
  list.PathArcTo(centre, radius, start, end, 16);
  list.PathStroke(color, 0, points(1.5F));
  const ImVec2 tail{centre.x - 0.59F * radius, centre.y - 0.81F * radius};
  const float head = radius * 0.75F;
  list.AddTriangleFilled({tail.x - head, tail.y + head * 0.9F}, {tail.x - head * 0.7F, tail.y - head},
                         {tail.x + head, tail.y + head * 0.5F}, color);
}

void draw_corners(ImVec2 centre, float reach, unsigned color) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float arm = 0.6F * reach;
  for (const float x : {-1.0F, 1.0F}) {
    for (const float y : {-1.0F, 1.0F}) {
      const ImVec2 corner{centre.x + x * reach, centre.y + y * reach};
      list.PathLineTo({corner.x - x * arm, corner.y});
      list.PathLineTo(corner);
      list.PathLineTo({corner.x, corner.y - y * arm});
      list.PathStroke(color, 0, points(1.5F));
    }
  }
}

}  // namespace

// Not by ImGui::GetFontSize(), which is 0 before the panel has first run: the planet makes room for it before.
float points(float count) { return count * ImGui::GetIO().Fonts->ConfigData.front().SizePixels / kFontSize; }

void bar(const char* id, double position, const std::string& text, float width) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 to{from.x + width, from.y + ImGui::GetFrameHeight()};
  ImGui::InvisibleButton(id, {width, to.y - from.y});
  draw_bar(from, to, position, text);
  mark_focus();
}

double position_on_bar(float x) {
  const float inset = points(bar_inset), left = ImGui::GetItemRectMin().x + inset;
  return (double{x} - left) / (double{ImGui::GetItemRectSize().x} - 2.0 * inset);
}

float reset_button_width() { return ImGui::GetFrameHeight(); }

bool reset_button(const char* id) {
  const float side = reset_button_width();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(id, {side, side});
  const unsigned color = ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_Text : ImGuiCol_CheckMark);
  draw_turn_back({from.x + side * 0.5F, from.y + side * 0.5F}, side * 0.24F, color);
  mark_focus();
  return pressed;
}

bool full_screen_button(const char* id) {
  const float side = ImGui::GetFrameHeight();
  ImGui::PushID(id);
  const bool pressed = ImGui::Button("##", {side, side});
  ImGui::PopID();
  const ImVec2 from = ImGui::GetItemRectMin();
  draw_corners({from.x + 0.5F * side, from.y + 0.5F * side}, points(5.0F), ImGui::GetColorU32(ImGuiCol_Text));
  return pressed;
}

bool choice_row(const std::string& text, bool chosen) {
  // A Selectable adds the space between rows to its height.
  const float height = ImGui::GetFrameHeight() - ImGui::GetStyle().ItemSpacing.y;
  return ImGui::Selectable(text.c_str(), chosen, ImGuiSelectableFlags_None, {0.0F, height});
}

bool picture_row(const std::string& text, unsigned picture, bool chosen) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const ImVec2 size = {points(picture_width), points(picture_height)};
  const float height = std::max(size.y, ImGui::GetFrameHeight() - style.ItemSpacing.y);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  ImGui::Dummy(
      {size.x + style.ItemInnerSpacing.x + ImGui::CalcTextSize(text.c_str()).x, height});  // so wide is the list
  ImGui::SetCursorScreenPos(from);
  const bool pressed =
      ImGui::Selectable(text_of("##", text).c_str(), chosen, ImGuiSelectableFlags_None, {0.0F, height});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 corner = {from.x, from.y + 0.5F * (height - size.y)}, end = {corner.x + size.x, corner.y + size.y};
  if (picture != 0) {
    list.AddImage(ImTextureID(std::uintptr_t{picture}), corner, end, {0.0F, 1.0F}, {1.0F, 0.0F});
  } else {
    list.AddRectFilled(corner, end, ImGui::GetColorU32(ImGuiCol_FrameBg));
  }
  list.AddText({end.x + style.ItemInnerSpacing.x, from.y + 0.5F * (height - ImGui::GetFontSize())},
               ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
  return pressed;
}

bool toggle_button(const char* label, bool on, float width) {
  const ImVec4 color = ImGui::GetStyleColorVec4(on ? ImGuiCol_ButtonActive : ImGuiCol_Button);
  ImGui::PushStyleColor(ImGuiCol_Button, color);
  const bool pressed = ImGui::Button(label, {width, 0.0F});
  ImGui::PopStyleColor();
  return pressed;
}

bool link_button(const char* label) {
  const ImVec2 size = ImGui::CalcTextSize(label);
  const float height = ImGui::GetFrameHeight();
  ImVec2 from = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(label, {size.x, height});
  from.y += 0.5F * (height - size.y);
  const unsigned color = ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_Text : ImGuiCol_CheckMark);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(from, color, label);
  list.AddLine({from.x, from.y + size.y}, {from.x + size.x, from.y + size.y}, color);
  mark_focus();
  return pressed;
}

void quiet_text(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
}

void two_columns(float share, const std::function<void()>& left, const std::function<void()>& right) {
  const float start = ImGui::GetCursorPosX(), middle = start + share * ImGui::GetContentRegionAvail().x;
  ImGui::PushTextWrapPos(middle - points(6.0F));
  ImGui::BeginGroup();
  left();
  ImGui::EndGroup();
  ImGui::PopTextWrapPos();
  ImGui::SameLine();
  ImGui::SetCursorPosX(middle);
  ImGui::BeginGroup();
  right();
  ImGui::EndGroup();
}

void begin_side_tooltip() {
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() + points(6.0F);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float y = keyboard_is_here() ? ImGui::GetItemRectMin().y : ImGui::GetIO().MousePos.y;
  // On a narrow window it goes where Dear ImGui sees fit.
  if (right + points(tooltip_width) < display.x) {
    ImGui::SetNextWindowPos({right, y}, ImGuiCond_Always, {0.0F, y > display.y * 0.6F ? 1.0F : 0.0F});
  }
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(points(tooltip_width));
}

void end_side_tooltip() {
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void tooltip(const std::string& text) {
  if (!ImGui::IsItemHovered() || hand_is_busy()) return;
  begin_side_tooltip();
  ImGui::TextWrapped("%s", text.c_str());
  end_side_tooltip();
}

}  // namespace terrella
