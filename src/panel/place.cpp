#include "panel/place.hpp"

#include <imgui.h>

#include <algorithm>

#include "panel/panel.hpp"
#include "panel/widgets.hpp"

namespace terrella {
namespace {

constexpr float panel_width = 340.0F, panel_margin = 8.0F;  // points
constexpr float widest_share = 0.9F;                        // of the window
constexpr float narrow = 600.0F;                            // points
constexpr float sheet_share = 0.45F;                        // of the window's height
constexpr float least_sheet = 180.0F;                       // points; lower, one could not scroll in it
constexpr float spared_share = 0.25F;                       // of the window's width, for which the planet makes no room

constexpr ImGuiWindowFlags always = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoFocusOnAppearing;

float width_at_the_left() { return std::min(points(panel_width), widest_share * ImGui::GetIO().DisplaySize.x); }

float height_of_sheet() {
  const float display = ImGui::GetIO().DisplaySize.y;
  return std::min(display, std::max(sheet_share * display, points(least_sheet)));
}

bool begin_at_the_left(bool folded) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float margin = points(panel_margin);
  const float width = folded ? 0.0F : width_at_the_left();
  ImGui::SetNextWindowPos({margin, margin});
  ImGui::SetNextWindowSizeConstraints({width, 0.0F},
                                      {folded ? display.x : width, std::max(margin, display.y - 2.0F * margin)});
  return ImGui::Begin("panel", nullptr, always | ImGuiWindowFlags_AlwaysAutoResize);
}

// Windows of their own: the one at the left has another size, which Dear ImGui keeps.
bool begin_sheet(PanelPlace place) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  if (place.folded) {
    ImGui::SetNextWindowPos({0.5F * display.x, display.y - points(panel_margin)}, ImGuiCond_Always, {0.5F, 1.0F});
    return ImGui::Begin("handle", nullptr, always | ImGuiWindowFlags_AlwaysAutoResize);
  }
  ImGui::SetNextWindowPos({0.0F, display.y}, ImGuiCond_Always, {0.0F, 1.0F});
  ImGui::SetNextWindowSize({display.x, height_of_sheet()});
  return ImGui::Begin("sheet", nullptr, always | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
}

bool rows_scroll_alone(PanelPlace place) { return place.below && !place.folded; }

}  // namespace

PanelPlace first_panel_place(int width, int height, bool fingers) {
  const bool below = static_cast<float>(width) < narrow || (fingers && height > width);
  return {below, below || (fingers && static_cast<float>(height) < kLowWindow)};
}

bool begin_panel_window(PanelPlace place) { return place.below ? begin_sheet(place) : begin_at_the_left(place.folded); }

void end_panel_window() { ImGui::End(); }

void begin_rows(PanelPlace place) {
  if (rows_scroll_alone(place))
    ImGui::BeginChild("rows", {0.0F, 0.0F}, ImGuiChildFlags_None, ImGuiWindowFlags_NavFlattened);
}

void end_rows(PanelPlace place) {
  if (rows_scroll_alone(place)) ImGui::EndChild();
}

Covered covered_by(PanelPlace place) {
  if (place.folded) return {};
  if (place.below) return {0.0F, height_of_sheet()};
  const float width = points(panel_margin) + width_at_the_left();
  return {width > spared_share * ImGui::GetIO().DisplaySize.x ? width : 0.0F, 0.0F};
}

}  // namespace terrella
