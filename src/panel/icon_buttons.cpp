#include "panel/icon_buttons.hpp"

#include <imgui.h>

#include "panel/keyboard.hpp"
#include "panel/widgets.hpp"

namespace terrella {
namespace {

constexpr float line = 1.5F;  // points

struct Sign {
  bool pressed, lit;
  ImVec2 centre;
  float radius;  // pixels
};

Sign square_button(const char* id) {
  const float side = reset_button_width();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(id, {side, side});
  mark_focus();
  return {pressed, ImGui::IsItemHovered(), {from.x + side * 0.5F, from.y + side * 0.5F}, side * 0.3F};
}

void draw_die(const Sign& sign, unsigned color) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto [x, y] = sign.centre;
  const float r = sign.radius, step = r * 0.5F, dot = points(1.0F);
  list.AddRect({x - r, y - r}, {x + r, y + r}, color, points(2.0F), 0, points(1.0F));
  for (const float along : {-1.0F, 0.0F, 1.0F}) list.AddCircleFilled({x + along * step, y - along * step}, dot, color);
}

// Open, the shackle stands to the side and the body is hollow.
void draw_lock(const Sign& sign, bool locked, unsigned color) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  constexpr float pi = 3.14159265F;
  const auto [x, y] = sign.centre;
  const float r = sign.radius, bow = r * 0.6F, shift = locked ? 0.0F : 2.0F * bow;
  const ImVec2 from{x - r * 0.9F, y - r * 0.1F}, to{x + r * 0.9F, y + r};
  list.PathLineTo({x - bow + shift, from.y});
  list.PathArcTo({x + shift, y - r * 0.45F}, bow, pi, 2.0F * pi, 10);
  list.PathLineTo({x + bow + shift, locked ? from.y : y - r * 0.3F});
  list.PathStroke(color, 0, points(line));
  if (locked) return list.AddRectFilled(from, to, color, points(1.0F));
  list.AddRect(from, to, color, points(1.0F), 0, points(1.0F));
}

unsigned color_of(const Sign& sign, ImGuiCol quiet) { return ImGui::GetColorU32(sign.lit ? ImGuiCol_Text : quiet); }

}  // namespace

bool random_button(const char* id) {
  const Sign sign = square_button(id);
  draw_die(sign, color_of(sign, ImGuiCol_TextDisabled));
  return sign.pressed;
}

bool lock_button(const char* id, bool locked, bool shown) {
  const Sign sign = square_button(id);
  if (locked || shown) draw_lock(sign, locked, color_of(sign, locked ? ImGuiCol_CheckMark : ImGuiCol_TextDisabled));
  return sign.pressed;
}

}  // namespace terrella
