#include "panel/slider_hand.hpp"

#include <imgui.h>
#include <imgui_internal.h>  // SetItemKeyOwner: that the wheel does not scroll as well

#include <algorithm>
#include <cmath>

#include "panel/finger_scroll.hpp"
#include "panel/keyboard.hpp"
#include "panel/widgets.hpp"

namespace terrella {
namespace {

constexpr float rest_radius = 3.0F;  // points; a hand that moves less has not moved
constexpr double fine = 0.1;         // with Ctrl

bool fine_wanted() { return ImGui::GetIO().KeyCtrl; }

void press(Grip& grip, std::string_view path, double position, double value) {
  grip = {};
  grip.path = path;
  grip.before = value;
  grip.stays = fine_wanted() || by_finger();
  grip.x = ImGui::GetIO().MousePos.x;
  grip.position = grip.stays ? position : position_on_bar(grip.x);
}

// A finger may as well be about to scroll.
bool has_moved() {
  if (!by_finger()) return ImGui::IsMouseDragging(ImGuiMouseButton_Left, points(rest_radius));
  const ImVec2 moved = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, finger_rest());
  return moved.x != 0.0F && std::fabs(moved.x) >= std::fabs(moved.y);
}

// Returns whether the slider follows the hand in this frame.
bool drag(Grip& grip) {
  const float x = ImGui::GetIO().MousePos.x;
  if (!ImGui::IsMousePosValid()) return false;
  if (has_moved()) grip.stays = false;
  const double moved = position_on_bar(x) - position_on_bar(grip.x);
  grip.x = x;
  if (!grip.stays) grip.position += moved * (fine_wanted() ? fine : 1.0);
  return !grip.stays;
}

// Whole notches turned over the slider drawn last; what touchpads give in small parts is gathered.
double turned(Wheel& wheel, std::string_view path) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool scrolling = io.MousePos.x == wheel.scrolled_x && io.MousePos.y == wheel.scrolled_y;
  if (!ImGui::IsItemHovered() || ImGui::IsItemActive() || scrolling) return 0.0;
  ImGui::SetItemKeyOwner(ImGuiKey_MouseWheelY);
  if (wheel.path != path) wheel.turned = 0.0;
  wheel.path = path;
  wheel.taken = true;
  wheel.turned += io.MouseWheel;
  const double notches = std::trunc(wheel.turned);
  wheel.turned -= notches;
  return fine_wanted() ? fine * notches : notches;
}

}  // namespace

SliderWish hand_on_slider(SliderHand& hand, std::string_view path, double position, double value) {
  SliderWish wish;
  Grip& grip = hand.grip;
  wish.steps = turned(hand.wheel, path) + steps_by_arrows();
  if (pressed_by_key()) {
    wish.type = value;
    grip = {};
  } else if (ImGui::IsItemActivated() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && grip.path == path) {
    wish.type = grip.before;
    wish.takes_back = true;
    grip = {};
  } else if (ImGui::IsItemActivated()) {
    press(grip, path, position, value);
  }
  if (grip.path != path) return wish;
  if (ImGui::IsItemActive() && drag(grip)) wish.position = std::clamp(grip.position, 0.0, 1.0);
  // Not where the press was taken away, to scroll or for a second finger.
  if (ImGui::IsItemDeactivated() && grip.stays && ImGui::IsMouseReleased(ImGuiMouseButton_Left)) {
    if (by_finger() && ImGui::IsMousePosValid()) wish.position = std::clamp(position_on_bar(grip.x), 0.0, 1.0);
    if (!by_finger()) wish.type = value;
  }
  return wish;
}

void note_scrolling(Wheel& wheel) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseWheel != 0.0F && !wheel.taken) {
    wheel.scrolled_x = io.MousePos.x;
    wheel.scrolled_y = io.MousePos.y;
  }
  wheel.taken = false;
}

}  // namespace terrella
