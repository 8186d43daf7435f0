#include "panel/caret.hpp"

#include <imgui.h>
#include <imgui_internal.h>  // the window that is typed in, and where

#include <algorithm>
#include <utility>

namespace terrella {
namespace {

bool is_popup(const ImGuiWindow& window) { return (window.Flags & ImGuiWindowFlags_Popup) != 0; }

// The innermost window around it that scrolls, or the popup that it is in.
ImGuiWindow* scrolling_around(ImGuiWindow* window) {
  while (window != nullptr && !is_popup(*window) && window->ScrollMax.y <= 0.0F) window = window->ParentWindow;
  return window;
}

}  // namespace

void keep_caret_in_sight(Caret& caret) {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const float height = context.IO.DisplaySize.y;
  if (std::exchange(caret.window_height, height) > height) caret.frames_to_follow = 3;  // until all have their new size
  if (caret.frames_to_follow == 0) return;
  --caret.frames_to_follow;
  ImGuiWindow* const window = scrolling_around(context.ActiveIdWindow);
  if (!context.PlatformImeData.WantVisible || window == nullptr) return;
  if (is_popup(*window)) {
    const float lowest = height - window->Size.y;  // where all of it is in sight, or at least its end
    return ImGui::SetWindowPos(window, {window->Pos.x, std::min(window->Pos.y, lowest)});
  }
  const float middle = window->InnerRect.GetCenter().y;
  ImGui::SetScrollY(window, window->Scroll.y + context.PlatformImeData.InputPos.y - middle);
}

}  // namespace terrella
