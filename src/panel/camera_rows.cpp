#include "panel/camera_rows.hpp"

#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <string>

#include "base/text.hpp"
#include "panel/go_to_row.hpp"
#include "panel/map_view.hpp"
#include "panel/parameter_row.hpp"
#include "panel/place.hpp"
#include "panel/widgets.hpp"

namespace terrella {

void camera_rows(Sheet& sheet) {
  constexpr auto count = static_cast<float>(std::size(camera_mode_texts));
  const float room = row_label("Move"), space = ImGui::GetStyle().ItemInnerSpacing.x;
  // As wide as the sliders below, where there is room.
  const float row = std::max(room - 2.0F * reset_button_width(), 0.8F * room);
  const float width = std::max(1.0F, (row - (count - 1.0F) * space) / count);
  for (const CameraModeText& text : camera_mode_texts) {
    const std::string label = text_of(text.title, "###camera_", text.name);
    const bool on = sheet.facts.camera_mode == text.mode;
    if (toggle_button(label.c_str(), on, width) && !on) sheet.wishes.camera_mode = text.mode;
    sheet.place("camera/", text.name);
    tooltip(std::string(text.help));
    ImGui::SameLine(0.0F, space);
  }
  ImGui::NewLine();
  if (ImGui::GetIO().DisplaySize.y >= points(kLowWindow)) map_view(sheet);  // else it would take all the room
  go_to_row(sheet);
}

}  // namespace terrella
