#include "panel/map_view.hpp"

#include <imgui.h>
#include <imgui_internal.h>  // PushItemFlag

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "panel/quantity.hpp"
#include "panel/widgets.hpp"

namespace terrella {
namespace {

constexpr float widest = 400.0F;  // points
constexpr double degree = std::numbers::pi / 180.0;
constexpr float night_opacity = 0.62F;
constexpr double dusk = 0.12;  // sine of the sun's height over and under which it is day and night

// Where the map lies, pixels.
struct MapBox {
  ImVec2 from, to;

  [[nodiscard]] ImVec2 point(double latitude, double longitude) const {
    const auto x = static_cast<float>(longitude / 360.0 + 0.5), y = static_cast<float>(0.5 - latitude / 180.0);
    return {from.x + x * (to.x - from.x), from.y + y * (to.y - from.y)};
  }
  [[nodiscard]] Destination place_at(ImVec2 point) const {
    const auto share = [](float x, float a, float b) { return std::clamp(double{x - a} / double{b - a}, 0.0, 1.0); };
    return {180.0 * (0.5 - share(point.y, from.y, to.y)), 360.0 * (share(point.x, from.x, to.x) - 0.5), std::nullopt};
  }
};

// Of the sun over a place's horizon.
double sine_of_height(const Scene& scene, double latitude, double longitude) {
  const double here = latitude * degree, there = scene.sun.latitude * degree;
  const double away = (longitude - scene.sun.longitude) * degree;
  return std::sin(here) * std::sin(there) + std::cos(here) * std::cos(there) * std::cos(away);
}

ImU32 night_at(const Scene& scene, double latitude, double longitude) {
  const double part = std::clamp(0.5 - 0.5 * sine_of_height(scene, latitude, longitude) / dusk, 0.0, 1.0);
  return ImGui::GetColorU32({0.0F, 0.01F, 0.04F, night_opacity * static_cast<float>(part)});
}

// A grid of squares, whose colours blend between their corners.
void draw_night(ImDrawList& list, const MapBox& box, const Scene& scene) {
  constexpr unsigned columns = 48, rows = 24;
  const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
  list.PrimReserve(6 * columns * rows, (columns + 1) * (rows + 1));
  const unsigned first = list._VtxCurrentIdx;
  for (unsigned row = 0; row <= rows; ++row) {
    for (unsigned column = 0; column <= columns; ++column) {
      const double latitude = 90.0 - 180.0 * row / rows, longitude = 360.0 * column / columns - 180.0;
      list.PrimWriteVtx(box.point(latitude, longitude), white, night_at(scene, latitude, longitude));
    }
  }
  for (unsigned row = 0; row < rows; ++row) {
    for (unsigned column = 0; column < columns; ++column) {
      const unsigned corner = first + row * (columns + 1) + column, below = corner + columns + 1;
      for (const unsigned index : {corner, corner + 1, below + 1, corner, below + 1, below}) {
        list.PrimWriteIdx(static_cast<ImDrawIdx>(index));
      }
    }
  }
}

// An arrow that points where the camera faces.
void draw_camera(ImDrawList& list, const MapBox& box, const Scene& scene) {
  const auto& camera = scene.camera;
  // The map is stretched along the parallels.
  const double stretched = 1.0 / std::max(std::cos(camera.latitude * degree), 0.05);
  const double east = std::sin(camera.heading * degree) * stretched, north = std::cos(camera.heading * degree);
  const double length = std::hypot(east, north);
  const ImVec2 ahead(static_cast<float>(east / length), static_cast<float>(-north / length));
  const ImVec2 at = box.point(camera.latitude, camera.longitude);
  const auto corner = [&](float along, float aside) {
    return ImVec2(at.x + points(along) * ahead.x - points(aside) * ahead.y,
                  at.y + points(along) * ahead.y + points(aside) * ahead.x);
  };
  const ImVec2 arrow[] = {corner(9.0F, 0.0F), corner(-6.0F, 6.0F), corner(-3.0F, 0.0F), corner(-6.0F, -6.0F)};
  list.AddTriangleFilled(arrow[0], arrow[1], arrow[2], ImGui::GetColorU32(ImGuiCol_CheckMark));
  list.AddTriangleFilled(arrow[0], arrow[2], arrow[3], ImGui::GetColorU32(ImGuiCol_CheckMark));
  list.AddPolyline(arrow, 4, ImGui::GetColorU32({0.0F, 0.0F, 0.0F, 0.8F}), ImDrawFlags_Closed, points(1.3F));
}

void draw_cross(ImDrawList& list, const MapBox& box, ImVec2 at) {
  const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text, 0.6F);
  list.AddLine({box.from.x, at.y}, {box.to.x, at.y}, color);
  list.AddLine({at.x, box.from.y}, {at.x, box.to.y}, color);
}

std::string words_of(const Destination& there) {
  const auto angle = [](double value, const char* positive, const char* negative) {
    return text_of(short_number(std::round(10.0 * std::abs(value)) / 10.0), "\u00b0 ",
                   value < 0.0 ? negative : positive);
  };
  return text_of(angle(there.latitude, "N", "S"), ", ", angle(there.longitude, "E", "W"), ": press to fly there.");
}

}  // namespace

void map_view(Sheet& sheet) {
  const Scene& scene = sheet.document.scene;
  sheet.memory.map_shown = true;
  const float width = std::min(ImGui::GetContentRegionAvail().x, points(widest));
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const MapBox box = {from, {from.x + width, from.y + std::round(0.5F * width)}};
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);  // keys have the row below
  const bool pressed = ImGui::InvisibleButton("map", {width, box.to.y - from.y});
  ImGui::PopItemFlag();
  sheet.place("camera/map");
  const bool held = ImGui::IsItemActive(), pointed_at = ImGui::IsItemHovered();
  const Destination there = box.place_at(ImGui::GetMousePos());

  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(box.from, box.to, true);
  if (sheet.facts.map != 0) list.AddImage(ImTextureID(std::uintptr_t{sheet.facts.map}), box.from, box.to);
  draw_night(list, box, scene);
  if (held || pointed_at) draw_cross(list, box, box.point(there.latitude, there.longitude));
  draw_camera(list, box, scene);
  list.PopClipRect();
  if (held || pointed_at) tooltip(words_of(there));
  if (pressed && ImGui::IsMousePosValid()) sheet.wishes.go_to = there;
}

}  // namespace terrella
