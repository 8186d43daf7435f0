#include "panel/go_to_row.hpp"

#include <imgui.h>

#include <string>
#include <variant>

#include "base/text.hpp"
#include "panel/keyboard.hpp"
#include "panel/parameter_row.hpp"
#include "panel/quantity.hpp"
#include "panel/typing.hpp"
#include "panel/widgets.hpp"

namespace terrella {
namespace {

constexpr std::string_view path = "camera/go_to";

// "14°, 0°, 2.25 m"
template <class Write>
std::string place_of_camera(const Scene& scene, const Write& write) {
  const auto number = [&](const char* parameter, double value) { return write(*find_parameter(parameter), value); };
  return text_of(number("camera.latitude", scene.camera.latitude), ", ",
                 number("camera.longitude", scene.camera.longitude), ", ",
                 number("camera.altitude", scene.camera.altitude));
}

void obey(Sheet& sheet, std::string_view typed) {
  auto read = read_destination(typed, sheet.document.scene.camera.altitude);
  if (auto* there = std::get_if<Destination>(&read)) sheet.wishes.go_to = *there;
  if (auto* sentence = std::get_if<std::string>(&read)) sheet.memory.no_place = *sentence;
}

void field(Sheet& sheet) {
  const auto typed = typing_field(sheet.memory.typing);
  sheet.place(path);
  if (sheet.memory.typing.path.empty() && keyboard_is_here()) focus_again("###go_to");
  if (typed) obey(sheet, *typed);
}

void place_button(Sheet& sheet, float width) {
  const Scene& scene = sheet.document.scene;
  const std::string label = text_of(place_of_camera(scene, quantity_text), "###go_to");
  const bool pressed = ImGui::Button(label.c_str(), {width, 0.0F});
  sheet.place(path);
  tooltip("Type a latitude, a longitude and, if you like, an altitude: the camera flies there.");
  if (!pressed) return;
  sheet.memory.no_place.clear();
  start_typing(sheet.memory.typing, path, place_of_camera(scene, quantity_to_edit));
}

}  // namespace

void go_to_row(Sheet& sheet) {
  const float width = row_label("Go to");
  ImGui::SetNextItemWidth(width);
  if (sheet.memory.typing.path == path) {
    field(sheet);
  } else {
    place_button(sheet, width);
  }
  if (!sheet.memory.no_place.empty()) quiet_text(sheet.memory.no_place);
}

}  // namespace terrella
