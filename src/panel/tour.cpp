#include "panel/tour.hpp"

#include <imgui.h>
#include <imgui_internal.h>  // the order of windows

#include <algorithm>
#include <iterator>

#include "base/text.hpp"
#include "panel/place.hpp"
#include "panel/widgets.hpp"

namespace terrella {
namespace {

struct Stop {
  std::string_view target;  // the widget it points to; empty: the planet
  const char* title;
  const char* text;
};

constexpr Stop stops[] = {
    {"", "Drag the planet", "It turns as you drag. The wheel or two fingers bring you nearer."},
    {"preset", "Pick a preset", "Each world in this list is one to start from. Random draws another by chance."},
    {"terrain", "Move a slider", "Open a group, and drag what you want to change. Undo takes anything back."},
    {"copy_link", "Copy link", "The link holds the planet that you made, for a friend or for later."},
};
constexpr int count = static_cast<int>(std::size(stops));

constexpr float bubble_width = 240.0F, gap = 14.0F, margin = 8.0F, tip = 8.0F;  // points
constexpr float height_of_first = 0.87F;                                        // its lower edge, of the window

const Stop& stop_of(const Tour& tour) { return stops[std::clamp(tour.step, 0, count - 1)]; }

void begin_bubble(ImVec2 at, ImVec2 pivot, float width) {
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, pivot);
  ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, ImGui::GetIO().DisplaySize.y});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
  ImGui::PushStyleColor(ImGuiCol_Border, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, points(1.0F));
  ImGui::Begin("tour", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  // A sheet that is touched comes to the front; lists that open belong before the bubble.
  const bool list_open = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (!list_open) ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
}

void contents(Sheet& sheet, const Stop& stop) {
  Tour& tour = sheet.memory.tour;
  const bool last = tour.step >= count - 1;
  ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", stop.title);
  ImGui::TextWrapped("%s", stop.text);
  ImGui::Spacing();
  const float width = points(56.0F), space = ImGui::GetStyle().ItemSpacing.x;
  const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  ImGui::AlignTextToFramePadding();
  quiet_text(text_of(tour.step + 1, " of ", count));
  if (!last) {
    ImGui::SameLine(right - 2.0F * width - space, 0.0F);
    if (ImGui::Button("Skip", {width, 0.0F})) tour.wanted = false;
    sheet.place("tour/skip");
  }
  ImGui::SameLine(right - width, 0.0F);
  const bool on = ImGui::Button(last ? "Done###next" : "Next###next", {width, 0.0F});
  sheet.place("tour/next");
  if (on && last) tour.wanted = false;
  if (on) {
    ++tour.step;
    tour.arrived = false;
    sheet.memory.folded = false;  // what is shown next is on the panel
  }
}

// From the bubble to the middle of what it is about. way: from its point to its base, a unit along an axis.
void draw_tip(ImVec2 at, ImVec2 way) {
  const float length = points(tip), half = 0.7F * length;
  const ImVec2 base = {at.x + length * way.x, at.y + length * way.y};
  const ImVec2 a = {base.x - half * way.y, base.y + half * way.x}, b = {base.x + half * way.y, base.y - half * way.x};
  ImGui::GetForegroundDrawList()->AddTriangleFilled(at, a, b, ImGui::GetColorU32(ImGuiCol_CheckMark));
}

void begin_over_the_planet(float panel_right, float free_height, float width, bool beside) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float middle = beside ? (panel_right + display.x) * 0.5F : display.x * 0.5F;
  begin_bubble({middle, std::min(height_of_first * display.y, free_height - points(gap))}, {0.5F, 1.0F}, width);
}

void begin_beside_the_panel(const Box& target, float panel_right, float width) {
  const float height = ImGui::GetIO().DisplaySize.y, edge = points(margin);
  const float y = std::clamp((target.top + target.bottom) * 0.5F, edge, height - edge);
  const bool is_low = y > height * 0.6F;
  const float lift = points(20.0F);
  begin_bubble({panel_right + points(gap), is_low ? y + lift : std::max(edge, y - lift)}, {0.0F, is_low ? 1.0F : 0.0F},
               width);
  draw_tip({panel_right + points(gap - tip), y}, {1.0F, 0.0F});
}

// Above or below what it is about.
void begin_along(const Box& target, float width, bool above) {
  const float edge = points(margin), x = (target.left + target.right) * 0.5F;
  const float left = std::clamp(x - 0.5F * width, edge, ImGui::GetIO().DisplaySize.x - edge - width);
  if (above) {
    const float y = target.top - points(gap);
    begin_bubble({left, y}, {0.0F, 1.0F}, width);
    draw_tip({x, y + points(tip)}, {0.0F, -1.0F});
  } else {
    const float y = target.bottom + points(gap);
    begin_bubble({left, y}, {0.0F, 0.0F}, width);
    draw_tip({x, y - points(tip)}, {0.0F, 1.0F});
  }
}

}  // namespace

std::string_view tour_target(const Tour& tour) { return tour.wanted ? stop_of(tour).target : std::string_view(); }

void note_tour_target(Tour& tour, std::string_view name) {
  if (name.empty() || name != tour_target(tour)) return;
  if (!tour.arrived) ImGui::SetScrollHereY(0.5F);
  tour.arrived = true;
  const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
  tour.target = {from.x, from.y, to.x, to.y};
}

void tour_bubble(Sheet& sheet, float panel_right) {
  Tour& tour = sheet.memory.tour;
  if (ImGui::IsKeyPressed(ImGuiKey_Escape, false) && !sheet.memory.keyboard.busy) tour.wanted = false;
  const Stop& stop = stop_of(tour);
  const PanelPlace place = sheet.memory.place();
  if (!tour.wanted || sheet.memory.keys_shown || (place.folded && !stop.target.empty())) return;
  const float edge = points(margin), room = ImGui::GetIO().DisplaySize.x - 2.0F * edge;
  const float width = std::min(points(bubble_width), room);
  const bool beside = !place.below && panel_right + points(gap) + width <= room + edge;
  if (stop.target.empty()) {
    begin_over_the_planet(panel_right, ImGui::GetIO().DisplaySize.y - covered_by(place).below, width, beside);
  } else if (beside) {
    begin_beside_the_panel(tour.target, panel_right, width);
  } else {
    begin_along(tour.target, width, place.below);
  }
  contents(sheet, stop);
  ImGui::End();
}

}  // namespace terrella
