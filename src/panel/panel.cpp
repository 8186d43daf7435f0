#include "panel/panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/check.hpp"
#include "base/text.hpp"
#include "panel/camera_rows.hpp"
#include "panel/caret.hpp"
#include "panel/facts_view.hpp"
#include "panel/finger_scroll.hpp"
#include "panel/habits.hpp"
#include "panel/head.hpp"
#include "panel/icon_buttons.hpp"
#include "panel/keyboard.hpp"
#include "panel/keys_window.hpp"
#include "panel/notices.hpp"
#include "panel/panel_state.hpp"
#include "panel/parameter_row.hpp"
#include "panel/place.hpp"
#include "panel/quality_rows.hpp"
#include "panel/search.hpp"
#include "panel/search_field.hpp"
#include "panel/sections.hpp"
#include "panel/sheet.hpp"
#include "panel/slider_hand.hpp"
#include "panel/tour.hpp"
#include "panel/widgets.hpp"
#include "scene/view_groups.hpp"

namespace terrella {
namespace {

// Returns whether the group is open.
bool group_header(Sheet& sheet, const Group& group) {
  const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  const std::string name(group.name);
  const bool open = section_header(sheet, group.name, group.title);
  tooltip(text_of(group.help, '.'));
  // Above the resets and locks of its rows.
  if (sheet.differs(group)) {
    ImGui::SameLine(right - 2.0F * reset_button_width(), 0.0F);
    if (reset_button(("reset " + name).c_str())) sheet.reset(group);
    sheet.place(name, "/reset");
    tooltip("The whole group as it is in the preset.");
  }
  if (!is_of_view(group.name)) {
    ImGui::SameLine(right - reset_button_width(), 0.0F);
    if (random_button(("random " + name).c_str())) sheet.surprise(group);
    sheet.place(name, "/random");
    tooltip("This group by chance, but for what is locked.");
  }
  return open;
}

// What some groups show beside their parameters.
void rows_above(Sheet& sheet, std::string_view group) {
  if (group == "camera") camera_rows(sheet);
  if (group == "quality") quality_rows(sheet);
}

void groups_section(Sheet& sheet) {
  for (const Group& group : groups()) {
    if (!group_header(sheet, group)) continue;
    rows_above(sheet, group.name);
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
      rows_above(sheet, group);
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

// In the window of the rows.
void note_how_far_down(Scrolling& scrolling) {
  scrolling.at = ImGui::GetScrollY();
  if (scrolling.frames_to_get > 0) ImGui::SetScrollY(scrolling.wanted);
  scrolling.frames_to_get = std::max(0, scrolling.frames_to_get - 1);
}

// In a low window what is searched for would have no room below all the rest.
bool found_need_the_room(const PanelMemory& memory) {
  return memory.search.text[0] != '\0' && ImGui::GetIO().DisplaySize.y < points(kLowWindow);
}

}  // namespace

Panel::Panel() {
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  memory_.chance.dice.seed(static_cast<std::minstd_rand::result_type>(now));
}

PanelWishes Panel::draw(SceneDocument& document, const PanelFacts& facts, std::vector<WidgetPlace>* places) {
  const Preset* preset = find_preset(document.preset);
  CHECK(preset != nullptr, "a document of the preset ", document.preset);
  Sheet sheet{document, preset, facts, memory_, places};
  memory_.presets_shown = memory_.map_shown = false;
  const PanelPlace place = memory_.place();  // a press folds it in the next frame
  const bool visible = begin_panel_window(place);
  if (std::exchange(memory_.keyboard.wanted, false)) terrella::take_keyboard();
  if (visible && place.folded) folded_section(sheet);
  if (visible && !place.folded) {
    title_row(sheet);
    begin_rows(place);
    const bool alone = found_need_the_room(memory_);
    if (!alone) {
      head_section(sheet);
      notices_section(sheet);
      clock_section(sheet);
      ImGui::Spacing();
    }
    search_field(sheet);
    if (std::exchange(memory_.search.alone, alone) != alone)
      ImGui::SetScrollHereY(0.0F);  // what was above it went or came
    sections_below_search(sheet);
    note_how_far_down(memory_.scrolling);
    end_rows(place);
  }
  note_scrolling(memory_.hand.wheel);
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth();
  end_panel_window();
  tour_bubble(sheet, right);
  keys_window(sheet);
  scroll_by_finger(memory_.finger);
  keep_caret_in_sight(memory_.caret);
  give_back_keyboard(memory_.keyboard, memory_.keys_shown);
  if (memory_.place().folded != place.folded) {
    forget_focus();
    if (memory_.keyboard.here) take_keyboard();
  }
  return sheet.wishes;
}

Covered Panel::covered() const { return covered_by(memory_.place()); }

std::string Panel::habits() const { return habits_of(memory_); }

void Panel::take_habits(std::string_view text) { terrella::take_habits(memory_, text); }

void Panel::add_state(NamedLines& lines) const { terrella::add_state(memory_, lines); }

void Panel::take_state(std::string_view text) { terrella::take_state(memory_, text); }

void Panel::surprise(SceneDocument& document) {
  document.scene = memory_.chance.draw(document.scene, memory_.chance.locked);
}

void Panel::start_search() {
  unfold();
  memory_.search.wanted = true;
}

}  // namespace terrella
