#include "panel/head.hpp"

#include <imgui.h>

#include <algorithm>

#include "base/text.hpp"
#include "panel/finger_scroll.hpp"
#include "panel/mix.hpp"
#include "panel/picture_menu.hpp"
#include "panel/preset_combo.hpp"
#include "panel/widgets.hpp"
#include "scene/view_groups.hpp"

namespace terrella {
namespace {

constexpr double longest_time = 1e9;    // s; about thirty years
constexpr float handle_width = 120.0F;  // points

// Right-aligned in its line.
void continue_at_right(float width) {
  ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - width, 0.0F);
}

// Whether the planet is not the preset's; wherever it is seen from.
bool is_changed(const Sheet& sheet) {
  return std::any_of(groups().begin(), groups().end(),
                     [&](const Group& group) { return !is_of_view(group.name) && sheet.differs(group); });
}

void preset_list(Sheet& sheet, float width) {
  const Preset& chosen = *sheet.preset;
  const std::string title = is_changed(sheet) ? text_of(chosen.title, ", changed") : chosen.title;
  const Preset* const picked = preset_combo(sheet, "preset", chosen, title, text_of(chosen.about, '.'), width);
  if (picked == nullptr) return;
  sheet.start_from(*picked);
  sheet.wishes.preset_chosen = true;
}

void preset_row(Sheet& sheet) {
  const float room = ImGui::GetContentRegionAvail().x, space = ImGui::GetStyle().ItemSpacing.x;
  const float wide = std::min(points(58.0F), 0.28F * room), narrow = std::min(points(40.0F), 0.2F * room);
  preset_list(sheet, room - wide - narrow - 2.0F * space);
  ImGui::SameLine();
  bool& mix_shown = sheet.memory.mix.shown;
  if (toggle_button("Mix", mix_shown, narrow)) mix_shown = !mix_shown;
  sheet.place("mix");
  tooltip("Mixes the planet with another preset.");
  ImGui::SameLine();
  if (ImGui::Button("Random", {wide, 0.0F})) sheet.surprise();
  sheet.place("random");
  tooltip("A planet by chance, but for what is locked (N).");
}

// What stands at the left of the buttons, where there is room for it.
void title(const Sheet& sheet, float room) {
  const bool comparing = sheet.facts.comparing;
  const char* const text = comparing ? "As opened" : "Terrella";
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(comparing ? ImGuiCol_CheckMark : ImGuiCol_Text));
  ImGui::TextUnformatted(ImGui::CalcTextSize(text).x < room ? text : "");
  ImGui::PopStyleColor();
  sheet.place(comparing ? "title/compared" : "title");
}

// Buttons of one width, three in a line.
class ButtonGrid {
 public:
  explicit ButtonGrid(Sheet& sheet) : sheet_(sheet) {
    width_ = (ImGui::GetContentRegionAvail().x - 2.0F * ImGui::GetStyle().ItemSpacing.x) / 3.0F;
  }

  bool button(const char* name, const char* label, const char* help) {
    if (count_++ % 3 != 0) ImGui::SameLine();
    ImGui::PushID(name);
    const bool pressed = ImGui::Button(label, {width_, 0.0F});
    sheet_.place(name);
    tooltip(help);
    ImGui::PopID();
    return pressed;
  }

  // Says that it has copied, until the pointer leaves it, or a finger comes again.
  bool copy_button(const char* name, const char* label, const char* help) {
    std::string_view& copied = sheet_.memory.copied;
    const bool pressed = button(name, copied == name ? "Copied" : label, help);
    const bool left = by_finger() ? ImGui::IsMouseDown(ImGuiMouseButton_Left) : !ImGui::IsItemHovered();
    if (copied == name && left) copied = {};
    if (pressed) copied = name;
    return pressed;
  }

 private:
  Sheet& sheet_;
  float width_;
  int count_ = 0;
};

}  // namespace

void title_row(Sheet& sheet) {
  const float space = ImGui::GetStyle().ItemSpacing.x, room = ImGui::GetContentRegionAvail().x;
  const float square = ImGui::GetFrameHeight(), width = std::min(points(46.0F), 0.22F * room);
  const bool can_fill = sheet.facts.can_fill_screen;
  const float buttons = 3.0F * width + square + 3.0F * space + (can_fill ? square + space : 0.0F);
  title(sheet, room - buttons);
  continue_at_right(buttons);
  const auto button = [&](const char* name, const char* label, const char* help, bool enabled = true) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(label, {label[1] == '\0' ? square : width, 0.0F});
    ImGui::EndDisabled();
    sheet.place(name);
    tooltip(help);
    ImGui::SameLine();
    return pressed;
  };
  const PanelFacts& facts = sheet.facts;
  if (button("undo", "Undo", "Takes the last change back (Ctrl+Z).", facts.can_undo)) sheet.wishes.undo = true;
  if (button("redo", "Redo", "Brings back what was undone (Ctrl+Shift+Z).", facts.can_redo)) sheet.wishes.redo = true;
  bool& keys_shown = sheet.memory.keys_shown;
  if (button("keys", "?", "Lists what keys and mouse do (?).")) keys_shown = !keys_shown;
  if (can_fill) {
    if (full_screen_button("fill_screen")) sheet.wishes.fill_screen = true;
    sheet.place("fill_screen");
    tooltip("Fills the screen, or leaves it (Shift+F).");
    ImGui::SameLine();
  }
  if (button("fold", "Fold", "Folds the panel to a button. The key H hides it, and brings it back.")) {
    sheet.memory.folded = true;
  }
  ImGui::NewLine();
}

void head_section(Sheet& sheet) {
  preset_row(sheet);
  mix_section(sheet);

  ButtonGrid grid(sheet);
  PanelWishes& wishes = sheet.wishes;
  if (grid.copy_button("copy_link", "Copy link", "A link to this planet, for the clipboard.")) wishes.copy_link = true;
  if (grid.copy_button("copy_json", "Copy JSON", "This scene as JSON, for the clipboard.")) wishes.copy_json = true;
  if (grid.button("save_picture", "Picture", "Saves a picture of the planet, of any size.")) open_picture_menu();
  if (grid.button("open", "Open", "Opens a scene from a JSON file.")) wishes.open_json = true;
  if (grid.button("save", "Save", "Saves this scene as a JSON file.")) wishes.save_json = true;
  const bool same = sheet.document.scene == sheet.preset->scene;
  ImGui::BeginDisabled(same);
  if (grid.button("reset_all", "Reset all", "Every value as it is in the preset.")) sheet.start_from(*sheet.preset);
  ImGui::EndDisabled();
  picture_menu(sheet);
}

void folded_section(Sheet& sheet) {
  const float width = sheet.memory.first_place.below ? points(handle_width) : 0.0F;
  if (ImGui::Button("Panel", {width, 0.0F})) sheet.memory.folded = false;
  sheet.place("unfold");
}

void clock_section(Sheet& sheet) {
  const bool paused = sheet.facts.paused;
  if (ImGui::Button(paused ? "Play###pause" : "Pause###pause", {points(64.0F), 0.0F})) sheet.wishes.paused = !paused;
  sheet.place("pause");
  tooltip("Stops everything that moves, or lets it go on (Space).");

  ImGui::SameLine();
  double seconds = sheet.facts.seconds;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - reset_button_width());
  const double least = 0.0;
  const auto speed = static_cast<float>(std::max(0.05, 0.002 * seconds));
  if (ImGui::DragScalar("##seconds", ImGuiDataType_Double, &seconds, speed, &least, &longest_time, "%.2f s",
                        ImGuiSliderFlags_AlwaysClamp)) {
    sheet.wishes.seconds = seconds;
  }
  sheet.place("seconds");
  tooltip("The planet's time. Drag it to and fro; Ctrl+click to type.");
  if (sheet.facts.seconds == 0.0) return;
  continue_at_right(reset_button_width());
  if (reset_button("to_zero")) sheet.wishes.seconds = 0.0;
  sheet.place("seconds/reset");
  tooltip("Back to the beginning.");
}

}  // namespace terrella
