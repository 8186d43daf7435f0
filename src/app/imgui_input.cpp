#include "app/imgui_input.hpp"

#include <imgui.h>
#include <imgui_internal.h>  // the queue of events

#include <cfloat>

namespace terrella::imgui_input {
namespace {

ImGuiKey imgui_key(Key key) {
  switch (key) {
    case Key::left: return ImGuiKey_LeftArrow;
    case Key::right: return ImGuiKey_RightArrow;
    case Key::up: return ImGuiKey_UpArrow;
    case Key::down: return ImGuiKey_DownArrow;
    case Key::page_up: return ImGuiKey_PageUp;
    case Key::page_down: return ImGuiKey_PageDown;
    case Key::home: return ImGuiKey_Home;
    case Key::end: return ImGuiKey_End;
    case Key::space: return ImGuiKey_Space;
    case Key::enter: return ImGuiKey_Enter;
    case Key::escape: return ImGuiKey_Escape;
    case Key::tab: return ImGuiKey_Tab;
    case Key::backspace: return ImGuiKey_Backspace;
    case Key::del: return ImGuiKey_Delete;
    case Key::a: return ImGuiKey_A;
    case Key::c: return ImGuiKey_C;
    case Key::v: return ImGuiKey_V;
    case Key::x: return ImGuiKey_X;
    case Key::y: return ImGuiKey_Y;
    case Key::z: return ImGuiKey_Z;
    default: return ImGuiKey_None;
  }
}

}  // namespace

void move(double x, double y) { ImGui::GetIO().AddMousePosEvent(static_cast<float>(x), static_cast<float>(y)); }

void pointer_is_finger(bool finger) {
  ImGui::GetIO().AddMouseSourceEvent(finger ? ImGuiMouseSource_TouchScreen : ImGuiMouseSource_Mouse);
}

void leave() { ImGui::GetIO().AddMousePosEvent(-FLT_MAX, -FLT_MAX); }

void button(int button, bool down) { ImGui::GetIO().AddMouseButtonEvent(button, down); }

void wheel(double notches) { ImGui::GetIO().AddMouseWheelEvent(0.0F, static_cast<float>(notches)); }

bool navigates(Key key) {
  switch (key) {
    case Key::left:
    case Key::right:
    case Key::up:
    case Key::down:
    case Key::page_up:
    case Key::page_down:
    case Key::home:
    case Key::end:
    case Key::space:
    case Key::enter:
    case Key::escape:
    case Key::tab: return true;
    default: return false;
  }
}

void key(Key key, bool down, Modifiers modifiers) {
  ImGuiIO& io = ImGui::GetIO();
  io.AddKeyEvent(ImGuiMod_Ctrl, modifiers.control);
  io.AddKeyEvent(ImGuiMod_Shift, modifiers.shift);
  if (imgui_key(key) != ImGuiKey_None) io.AddKeyEvent(imgui_key(key), down);
}

void paste(Modifiers held) {
  key(Key::v, true, {.shift = false, .control = true});
  key(Key::v, false, held);
}

void text(unsigned codepoint) { ImGui::GetIO().AddInputCharacter(codepoint); }

bool waiting() { return !ImGui::GetCurrentContext()->InputEventsQueue.empty(); }

}  // namespace terrella::imgui_input
