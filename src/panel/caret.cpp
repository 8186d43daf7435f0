#include "panel/caret.hpp"

#include <imgui.h>
#include <imgui_internal.h>  // the window that is typed in, and where

#include <utility>

namespace terrella {
namespace {

// The innermost window around it that scrolls.
ImGuiWindow* scrolling_around(ImGuiWindow* window) {
  while (window != nullptr && window->ScrollMax.y <= 0.0F) window = window->ParentWindow;
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
  const float middle = window->InnerRect.GetCenter().y;
  ImGui::SetScrollY(window, window->Scroll.y + context.PlatformImeData.InputPos.y - middle);
}

}  // namespace terrella
