#include "panel/panel.hpp"

#include <imgui.h>

#include <utility>

#include "base/check.hpp"
#include "base/text.hpp"
#include "panel/facts_view.hpp"
#include "panel/finger_scroll.hpp"
#include "panel/head.hpp"
#include "panel/keyboard.hpp"
#include "panel/keys_window.hpp"
#include "panel/parameter_row.hpp"
#include "panel/place.hpp"
#include "panel/search.hpp"
#include "panel/search_field.hpp"
#include "panel/sheet.hpp"
#include "panel/slider_hand.hpp"
#include "panel/widgets.hpp"

namespace terrella {
namespace {

// Returns whether the group is open.
bool group_header(Sheet& sheet, const Group& group) {
  const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  const std::string name(group.name);
  const bool open = ImGui::CollapsingHeader(text_of(group.title, "###", name).c_str(), ImGuiTreeNodeFlags_AllowOverlap);
  sheet.place(name);
  tooltip(text_of(group.help, '.'));
  if (sheet.differs(group)) {
    ImGui::SameLine(right - reset_button_width(), 0.0F);
    if (reset_button(("reset " + name).c_str())) sheet.reset(group);
    sheet.place(name, "/reset");
    tooltip("The whole group as it is in the preset.");
  }
  return open;
}

void groups_section(Sheet& sheet) {
  for (const Group& group : groups()) {
    if (!group_header(sheet, group)) continue;
    for (const Parameter& parameter : parameters()) {
      if (parameter.group == group.name) parameter_row(sheet, parameter);
    }
    ImGui::Spacing();
  }
}

// Groups under headers of their own, so that the others stay open or closed as they are.
void found_section(Sheet& sheet, std::string_view text) {
  const std::vector<const Parameter*> found = parameters_about(text);
  if (found.empty()) quiet_text(nothing_about(shortened(text)));
  std::string_view group;
  for (const Parameter* parameter : found) {
    if (parameter->group != group) {
      group = parameter->group;
      ImGui::SeparatorText(std::string(find_group(group)->title).c_str());
      sheet.place(group);
    }
    parameter_row(sheet, *parameter);
  }
}

void sections_below_search(Sheet& sheet) {
  const std::string_view text = sheet.memory.search.text.data();
  if (!text.empty()) return found_section(sheet, text);
  groups_section(sheet);
  decisions_section(sheet);
  statistics_section(sheet);
}

}  // namespace

PanelWishes Panel::draw(SceneDocument& document, const PanelFacts& facts, std::vector<WidgetPlace>* places) {
  const Preset* preset = find_preset(document.preset);
  CHECK(preset != nullptr, "a document of the preset ", document.preset);
  Sheet sheet{document, preset, facts, memory_, places};
  const PanelPlace place = memory_.place();  // a press folds it in the next frame
  const bool visible = begin_panel_window(place);
  if (std::exchange(memory_.keyboard.wanted, false)) terrella::take_keyboard();
  if (visible && place.folded) folded_section(sheet);
  if (visible && !place.folded) {
    title_row(sheet);
    begin_rows(place);
    head_section(sheet);
    notices_section(sheet);
    clock_section(sheet);
    ImGui::Spacing();
    search_field(sheet);
    sections_below_search(sheet);
    end_rows(place);
  }
  note_scrolling(memory_.hand.wheel);
  end_panel_window();
  keys_window(sheet);
  scroll_by_finger(memory_.finger);
  give_back_keyboard(memory_.keyboard, memory_.keys_shown);
  if (memory_.place().folded != place.folded) {
    forget_focus();
    if (memory_.keyboard.here) take_keyboard();
  }
  covered_below_ = height_of_sheet(memory_.place());
  return sheet.wishes;
}

void Panel::start_search() {
  memory_.folded = false;
  memory_.search.wanted = true;
}

}  // namespace terrella
