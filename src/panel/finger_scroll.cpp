#include "panel/finger_scroll.hpp"

#include <imgui.h>
#include <imgui_internal.h>  // the window under the finger, and who has the press

#include <cmath>

#include "panel/widgets.hpp"

namespace terrella {
namespace {

constexpr float rest = 8.0F;  // points

unsigned window_under_finger() {
  const ImGuiWindow* const window = ImGui::GetCurrentContext()->HoveredWindow;
  return window == nullptr ? 0 : window->ID;
}

void decide(FingerScroll& finger) {
  const ImVec2 moved = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, finger_rest());
  if (moved.x == 0.0F && moved.y == 0.0F) return;
  finger.decided = true;
  finger.scrolls = std::fabs(moved.y) > std::fabs(moved.x);
  if (finger.scrolls) ImGui::ClearActiveID();
}

}  // namespace

bool by_finger() { return ImGui::GetIO().MouseSource == ImGuiMouseSource_TouchScreen; }

float finger_rest() { return points(rest); }

void scroll_by_finger(FingerScroll& finger) {
  if (!by_finger() || !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    finger = {};
    return;
  }
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) finger = {window_under_finger(), false, false};
  ImGuiWindow* const window = ImGui::FindWindowByID(finger.window);
  if (window == nullptr || window->ScrollMax.y <= 0.0F) return;
  if (!finger.decided) decide(finger);
  if (finger.scrolls) ImGui::SetScrollY(window, window->Scroll.y - ImGui::GetIO().MouseDelta.y);
}

}  // namespace terrella
