#include "panel/keyboard.hpp"

#include <imgui.h>
#include <imgui_internal.h>  // the focus, and who owns a key

#include <utility>

namespace terrella {
namespace {

constexpr double fine = 0.1;  // with Ctrl

}  // namespace

void take_keyboard() {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  ImGuiWindow* const window = ImGui::GetCurrentWindow();
  const bool was_here = context.NavWindow != nullptr && context.NavWindow->RootWindow == window->RootWindow;
  if (!was_here || context.NavId == 0) {
    ImGui::FocusWindow(window);
    ImGui::NavInitWindow(window, true);
  }
  context.NavDisableHighlight = false;
  context.NavDisableMouseHover = true;  // the pointer rests somewhere
}

void forget_focus() { ImGui::GetCurrentContext()->NavId = 0; }

void focus_next_widget() {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  context.NavFocusScopeId = context.CurrentFocusScopeId;
  ImGui::SetKeyboardFocusHere();
}

bool keyboard_is_here() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const bool finding = context.NavInitRequest || context.NavId != 0;
  return context.NavWindow != nullptr && finding && !context.NavDisableHighlight;
}

void mark_focus() {
  const ImRect box(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  ImGui::RenderNavHighlight(box, ImGui::GetItemID());
}

void focus_again(const char* id) { ImGui::SetFocusID(ImGui::GetID(id), ImGui::GetCurrentWindow()); }

double steps_by_arrows() {
  if (!keyboard_is_here() || !ImGui::IsItemFocused()) return 0.0;
  double steps = 0.0;
  for (const auto& [key, step] : {std::pair(ImGuiKey_LeftArrow, -1.0), std::pair(ImGuiKey_RightArrow, 1.0)}) {
    if (ImGui::IsKeyPressed(key)) steps += step;
    ImGui::SetKeyOwner(key, ImGui::GetItemID());  // from the next frame on
  }
  return ImGui::GetIO().KeyCtrl ? fine * steps : steps;
}

bool pressed_by_key() {
  return ImGui::IsItemActivated() && ImGui::GetCurrentContext()->ActiveIdSource == ImGuiInputSource_Keyboard;
}

void give_back_keyboard(Keyboard& keyboard, bool keys_shown) {
  const bool escape = ImGui::IsKeyPressed(ImGuiKey_Escape, false);
  if (escape && !keyboard.busy) ImGui::GetCurrentContext()->NavDisableHighlight = true;
  keyboard.busy = keys_shown || ImGui::IsAnyItemActive() ||
                  ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  keyboard.here = keyboard_is_here();
}

}  // namespace terrella
