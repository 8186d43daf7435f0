#include "panel/finger_scroll.hpp"

#include <imgui.h>
#include <imgui_internal.h>  // the window under the finger, and who has the press

#include <algorithm>
#include <cmath>

#include "panel/widgets.hpp"

namespace terrella {
namespace {

constexpr float rest = 8.0F;              // points
constexpr float memory_of_speed = 0.05F;  // s
constexpr float runs_on = 0.35F;          // s in which it slows down to a third
constexpr float stands = 20.0F;           // points a second

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

void follow(FingerScroll& finger, ImGuiWindow* window) {
  const ImGuiIO& io = ImGui::GetIO();
  const float kept = std::exp(-io.DeltaTime / memory_of_speed);
  finger.speed = kept * finger.speed + (1.0F - kept) * io.MouseDelta.y / io.DeltaTime;
  ImGui::SetScrollY(window, window->Scroll.y - io.MouseDelta.y);
}

void run_on(FingerScroll& finger) {
  finger.decided = finger.scrolls = false;
  ImGuiWindow* const window = ImGui::FindWindowByID(finger.window);
  const float seconds = ImGui::GetIO().DeltaTime;
  if (window == nullptr || std::fabs(finger.speed) < points(stands)) {
    finger.speed = 0.0F;
    return;
  }
  const float wanted = window->Scroll.y - finger.speed * seconds;
  const float there = std::clamp(wanted, 0.0F, window->ScrollMax.y);
  ImGui::SetScrollY(window, there);
  finger.speed = there == wanted ? finger.speed * std::exp(-seconds / runs_on) : 0.0F;
}

}  // namespace

bool by_finger() { return ImGui::GetIO().MouseSource == ImGuiMouseSource_TouchScreen; }

float finger_rest() { return points(rest); }

void scroll_by_finger(FingerScroll& finger) {
  if (!by_finger()) {
    finger = {};
    return;
  }
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) return run_on(finger);
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    if (finger.speed != 0.0F) ImGui::ClearActiveID();  // the press only stops it
    finger = {window_under_finger(), false, false, 0.0F};
  }
  ImGuiWindow* const window = ImGui::FindWindowByID(finger.window);
  if (window == nullptr || window->ScrollMax.y <= 0.0F) return;
  if (!finger.decided) decide(finger);
  if (finger.scrolls) follow(finger, window);
}

}  // namespace terrella
