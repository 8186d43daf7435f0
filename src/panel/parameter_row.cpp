#include "panel/parameter_row.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "panel/finger_scroll.hpp"
#include "panel/icon_buttons.hpp"
#include "panel/keyboard.hpp"
#include "panel/quantity.hpp"
#include "panel/slider_hand.hpp"
#include "panel/slider_range.hpp"
#include "panel/typing.hpp"
#include "panel/widgets.hpp"

namespace terrella {
namespace {

constexpr float label_width = 124.0F;      // points
constexpr float narrowest_value = 110.0F;  // points; narrower, it takes the room of its lock
constexpr float narrowest_seed = 60.0F;    // points; narrower, its six digits do without - and + beside them
constexpr float picker_width = 220.0F;     // points: for fingers, too, it leaves the planet in sight
constexpr double widest_slider = 5000;     // of whole numbers; beyond, a pixel would skip too many

// "ridge_sharpness" as "Ridge sharpness"
std::string label_of(const Parameter& parameter) {
  std::string label = in_words(parameter.name);
  if (label[0] >= 'a' && label[0] <= 'z') label[0] = static_cast<char>(label[0] - 'a' + 'A');
  return label;
}

double number_of(const Sheet& sheet, const Parameter& parameter) {
  const Value value = parameter.get(sheet.document.scene);
  const auto* whole = std::get_if<int>(&value);
  return whole != nullptr ? *whole : std::get<double>(value);
}

// Without its unit where there is no room for both: what is cut off would be neither.
std::string text_in_bar(const Parameter& parameter, double value, float width) {
  std::string text = quantity_text(parameter, value);
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  return text.substr(0, text.find(' '));
}

void slider(Sheet& sheet, const Parameter& parameter, float width) {
  const double value = number_of(sheet, parameter);
  const SliderRange range = slider_range(parameter, sheet.document.scene);
  const double position = range.position_of(value);
  bar("value", position, text_in_bar(parameter, value, width), width);
  sheet.place(parameter.path);
  const SliderWish wish = hand_on_slider(sheet.memory.hand, parameter.path, position, value);
  if (wish.steps != 0.0) sheet.set(parameter, range.stepped(value, wish.steps));
  if (wish.position) sheet.set(parameter, range.value_at(*wish.position));
  if (!wish.type) return;
  if (wish.takes_back) sheet.wishes.takes_back = true;
  sheet.set(parameter, *wish.type);
  start_typing(sheet.memory.typing, parameter.path, quantity_to_edit(parameter, *wish.type));
}

void number_field(Sheet& sheet, const Parameter& parameter) {
  const double value = number_of(sheet, parameter);
  const auto typed = typing_field(sheet.memory.typing);
  sheet.place(parameter.path);
  if (sheet.memory.typing.path.empty() && keyboard_is_here()) focus_again("value");  // the slider comes back
  if (!typed) return;
  if (const auto number = read_quantity(*typed, parameter, value)) sheet.set(parameter, *number);
}

// For seeds: what counts is to get to the next one.
void stepper(Sheet& sheet, const Parameter& parameter, float width) {
  int value = std::get<int>(parameter.get(sheet.document.scene));
  const bool with_buttons = width - 2.0F * ImGui::GetFrameHeight() > points(narrowest_seed);
  if (ImGui::InputInt("##value", &value, with_buttons ? 1 : 0, with_buttons ? 100 : 0)) {
    sheet.set(parameter, std::clamp<double>(value, parameter.min, parameter.max));
  }
  sheet.place(parameter.path);
}

bool is_number(const Parameter& parameter) { return parameter.type == Type::Float || parameter.type == Type::Int; }

bool has_slider(const Parameter& parameter) {
  const bool long_row = parameter.type == Type::Int && parameter.max - parameter.min > widest_slider;
  return is_number(parameter) && !long_row;
}

void number_widget(Sheet& sheet, const Parameter& parameter, float width) {
  if (sheet.memory.typing.path == parameter.path) return number_field(sheet, parameter);
  if (!has_slider(parameter)) return stepper(sheet, parameter, width);
  slider(sheet, parameter, width);
}

void checkbox(Sheet& sheet, const Parameter& parameter) {
  bool value = std::get<bool>(parameter.get(sheet.document.scene));
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, points(1.0F));
  if (ImGui::Checkbox("##value", &value)) sheet.set(parameter, value);
  ImGui::PopStyleVar();
  sheet.place(parameter.path);
}

std::uint8_t to_byte(float channel) {
  return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(channel, 0.0F, 1.0F)));
}

// Dear ImGui's own is twelve rows wide, which are too many for a phone.
bool color_picker(float* rgb) {
  const ImVec4 color{rgb[0], rgb[1], rgb[2], 1.0F};
  const float side = ImGui::GetFrameHeight();
  const ImGuiColorEditFlags flags = ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop;
  if (ImGui::ColorButton("##swatch", color, flags, {side, side})) ImGui::OpenPopup("picker");
  if (!ImGui::BeginPopup("picker")) return false;
  const float room = ImGui::GetIO().DisplaySize.x - 4.0F * ImGui::GetStyle().WindowPadding.x;
  ImGui::SetNextItemWidth(std::min(points(picker_width), room));
  const bool changed = ImGui::ColorPicker3(
      "##picker", rgb,
      flags | ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoOptions | ImGuiColorEditFlags_DisplayHex);
  ImGui::EndPopup();
  return changed;
}

void color_field(Sheet& sheet, const Parameter& parameter, float width) {
  const Color color = std::get<Color>(parameter.get(sheet.document.scene));
  float rgb[] = {static_cast<float>(color.r) / 255.0F, static_cast<float>(color.g) / 255.0F,
                 static_cast<float>(color.b) / 255.0F};
  const ImGuiColorEditFlags flags = ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_NoLabel |
                                    ImGuiColorEditFlags_NoOptions | ImGuiColorEditFlags_NoTooltip |
                                    ImGuiColorEditFlags_NoDragDrop | ImGuiColorEditFlags_NoPicker |
                                    ImGuiColorEditFlags_NoSmallPreview;
  const float space = ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::BeginGroup();
  ImGui::SetNextItemWidth(width - ImGui::GetFrameHeight() - space);
  bool changed = ImGui::ColorEdit3("##value", rgb, flags);
  ImGui::SameLine(0.0F, space);
  changed = color_picker(rgb) || changed;
  ImGui::EndGroup();
  if (changed) sheet.set(parameter, Color{to_byte(rgb[0]), to_byte(rgb[1]), to_byte(rgb[2])});
  sheet.place(parameter.path);
}

void choice_list(Sheet& sheet, const Parameter& parameter) {
  const std::string chosen = std::get<std::string>(parameter.get(sheet.document.scene));
  const bool open = ImGui::BeginCombo("##value", chosen.c_str());
  sheet.place(parameter.path);
  if (!open) return;
  for (const std::string_view choice : parameter.choices) {
    const std::string name(choice);
    if (choice_row(name, name == chosen)) sheet.set(parameter, name);
    sheet.place(parameter.path, "/" + name);
  }
  ImGui::EndCombo();
}

// What file the planet has; its row's button for the preset's value clears it.
void file_field(Sheet& sheet, const Parameter& parameter, float width) {
  const std::string name = std::get<std::string>(parameter.get(sheet.document.scene));
  const bool pressed = ImGui::Button(((name.empty() ? "drop a file here" : name) + "###value").c_str(), {width, 0.0F});
  if (pressed) sheet.wishes.open_json = true;  // a map is opened as a scene is
  sheet.place(parameter.path);
}

void value_widget(Sheet& sheet, const Parameter& parameter, float width) {
  ImGui::SetNextItemWidth(width);
  switch (parameter.type) {
    case Type::Float:
    case Type::Int: number_widget(sheet, parameter, width); break;
    case Type::Bool: checkbox(sheet, parameter); break;
    case Type::Color: color_field(sheet, parameter, width); break;
    case Type::Choice: choice_list(sheet, parameter); break;
    case Type::File: file_field(sheet, parameter, width); break;
  }
  // Nobody drags while typing.
  if (ImGui::IsItemActive() && !ImGui::GetIO().WantTextInput) sheet.wishes.dragging = true;
}

// Returns whether the pointer is on it.
bool lock(Sheet& sheet, const Parameter& parameter, bool shown) {
  if (lock_button("lock", sheet.locked(parameter), shown)) sheet.toggle_lock(parameter);
  sheet.place(parameter.path, "/lock");
  return ImGui::IsItemHovered();
}

// In the unit in which it is shown, and counted when it is typed.
std::string text_of_value(const Parameter& parameter, const Scene& scene) {
  const Value value = parameter.get(scene);
  if (const auto* number = std::get_if<double>(&value)) return quantity_to_edit(parameter, *number);
  return to_text(value);
}

void explain(const Sheet& sheet, const Parameter& parameter, bool differs) {
  begin_side_tooltip();
  ImGui::TextWrapped("%s.", std::string(parameter.help).c_str());
  ImGui::Spacing();
  quiet_text(text_of(parameter.path, " = ", text_of_value(parameter, sheet.document.scene)));
  if (differs) quiet_text(text_of("In the preset: ", text_of_value(parameter, sheet.preset->scene)));
  if (is_number(parameter)) quiet_text(text_of(allowed_values(parameter), '.'));
  if (sheet.locked(parameter)) quiet_text("Locked: Random leaves it as it is.");
  const char* const by_hand =
      by_finger() ? "Tap it twice to type." : "Double click to type. The wheel goes in small steps; Ctrl is finer.";
  const char* const by_key = "Enter to type. Left and Right go in small steps; Ctrl is finer.";
  if (has_slider(parameter)) quiet_text(keyboard_is_here() ? by_key : by_hand);
  end_side_tooltip();
}

}  // namespace

float row_label(const std::string& text) {
  const float room = ImGui::GetContentRegionAvail().x - points(label_width);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text.c_str());
  ImGui::SameLine(ImGui::GetCursorPosX() + points(label_width), 0.0F);
  return room;
}

void parameter_row(Sheet& sheet, const Parameter& parameter) {
  const bool differs = sheet.differs(parameter);
  const float button = reset_button_width();
  ImGui::PushID(parameter.path.data(), parameter.path.data() + parameter.path.size());
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 to{from.x + width, from.y + ImGui::GetFrameHeight()};
  const bool pointed_at = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(from, to);
  const float left = width - points(label_width) - 2.0F * button;
  const float room_of_lock = left < points(narrowest_value) ? 0.0F : button;

  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(differs ? ImGuiCol_CheckMark : ImGuiCol_Text));
  row_label(label_of(parameter));
  ImGui::PopStyleColor();
  value_widget(sheet, parameter, width - points(label_width) - button - room_of_lock);
  const bool focused = keyboard_is_here() && ImGui::IsItemFocused() && !ImGui::IsItemActive();
  if (focused) explain(sheet, parameter, differs);
  if (differs) {
    ImGui::SameLine(ImGui::GetCursorPosX() + width - button - room_of_lock, 0.0F);
    if (reset_button("reset")) sheet.reset(parameter);
    sheet.place(parameter.path, "/reset");
  }
  bool on_lock = false;
  if (room_of_lock > 0.0F && is_for_chance(parameter)) {
    ImGui::SameLine(ImGui::GetCursorPosX() + width - room_of_lock, 0.0F);
    on_lock = lock(sheet, parameter, pointed_at || by_finger());  // a finger can't look for it
  }

  if (on_lock) {
    tooltip(sheet.locked(parameter) ? "Random leaves this value as it is. Click to unlock it."
                                    : "Click to lock this value: Random will leave it as it is.");
  } else if (pointed_at && !keyboard_is_here()) {
    explain(sheet, parameter, differs);
  }
  ImGui::PopID();
}

}  // namespace terrella
