#include "panel/typing.hpp"

#include <imgui.h>

#include <algorithm>

#include "panel/keyboard.hpp"

namespace terrella {
namespace {

// Dear ImGui gives the keyboard to a new field a frame or two after it was asked to.
constexpr int most_frames_waited = 4;

}  // namespace

void start_typing(Typing& typing, std::string_view path, const std::string& text) {
  typing = {};
  typing.path = path;
  std::copy_n(text.begin(), std::min(text.size(), typing.text.size() - 1), typing.text.begin());
  typing.before = typing.text.data();
}

std::optional<std::string> typing_field(Typing& typing) {
  if (typing.frames_waited == 0) focus_next_widget();
  ImGui::InputText("##typed", typing.text.data(), typing.text.size(), ImGuiInputTextFlags_AutoSelectAll);
  const bool active = ImGui::IsItemActive();
  if (active) typing.begun = true;
  if (active || (!typing.begun && ++typing.frames_waited < most_frames_waited)) return std::nullopt;
  const std::string typed = typing.text.data();
  const bool changed = typed != typing.before;
  typing = {};
  return changed ? std::optional(typed) : std::nullopt;
}

}  // namespace terrella
