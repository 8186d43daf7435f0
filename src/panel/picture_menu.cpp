#include "panel/picture_menu.hpp"

#include <imgui.h>

#include <algorithm>

#include "base/text.hpp"
#include "panel/widgets.hpp"

namespace terrella {
namespace {

constexpr const char* menu_name = "picture";
constexpr float field_width = 48.0F;  // points

struct Size {
  const char* name;
  const char* label;
  int width, height;  // pixels
};

constexpr Size common_sizes[] = {{"full_hd", "Full HD", 1920, 1080},
                                 {"4k", "4K", 3840, 2160},
                                 {"8k", "8K", 7680, 4320},
                                 {"square", "Square", 4096, 4096},
                                 {"phone", "Phone", 1440, 3120}};

void size_row(Sheet& sheet, const Size& size) {
  const bool chosen = choice_row(text_of(size.label, ": ", size.width, " \u00d7 ", size.height), false);
  sheet.place("picture/", size.name);
  if (chosen) sheet.wishes.save_picture = {size.width, size.height, sheet.memory.picture.transparent};
}

void field(Sheet& sheet, const char* name, int& pixels) {
  ImGui::SetNextItemWidth(points(field_width));
  ImGui::InputInt(text_of("##", name).c_str(), &pixels, 0);
  pixels = std::clamp(pixels, 1, sheet.facts.largest_picture);
  sheet.place("picture/", name);
}

void own_size(Sheet& sheet) {
  PictureSize& own = sheet.memory.picture;
  field(sheet, "width", own.width);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("\u00d7");
  ImGui::SameLine();
  field(sheet, "height", own.height);
  ImGui::SameLine();
  if (ImGui::Button("Save")) {
    sheet.wishes.save_picture = {own.width, own.height, own.transparent};
    ImGui::CloseCurrentPopup();
  }
  sheet.place("picture/own");
  // Not wrapped: before the window knows its width it would be so high that it opens elsewhere than at the pointer.
  ImGui::TextDisabled("Each side 1 to %d pixels.", sheet.facts.largest_picture);
}

}  // namespace

void open_picture_menu() { ImGui::OpenPopup(menu_name); }

void picture_menu(Sheet& sheet) {
  if (!ImGui::BeginPopup(menu_name)) return;
  ImGui::Checkbox("Without the sky", &sheet.memory.picture.transparent);
  sheet.place("picture/transparent");
  tooltip("The planet alone, on a transparent ground.");
  ImGui::Separator();
  size_row(sheet, {"window", "As shown", sheet.facts.width, sheet.facts.height});
  for (const Size& size : common_sizes) {
    if (std::max(size.width, size.height) <= sheet.facts.largest_picture) size_row(sheet, size);
  }
  ImGui::Separator();
  own_size(sheet);
  ImGui::EndPopup();
}

}  // namespace terrella
