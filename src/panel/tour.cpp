#include "panel/tour.hpp"

#include <imgui.h>

#include <algorithm>
#include <iterator>

#include "base/text.hpp"
#include "panel/widgets.hpp"

namespace terrella {
namespace {

struct Stop {
  std::string_view target;  // the widget it points to; empty: the planet
  const char* title;
  const char* text;
};

constexpr Stop stops[] = {
    {"", "Drag the planet", "It turns as you drag. The wheel, or two fingers, bring you nearer."},
    {"preset", "Pick a preset", "Each world in this list is one to start from. Random draws another by chance."},
    {"terrain", "Move a slider", "Open a group, and drag what you want to change. Undo takes anything back."},
    {"copy_link", "Copy link", "The link holds the planet that you made, for a friend or for later."},
};
constexpr int count = static_cast<int>(std::size(stops));

constexpr float bubble_width = 240.0F, gap = 14.0F, margin = 8.0F, tip = 8.0F;  // points
constexpr float height_of_first = 0.78F;                                        // of the window

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
  if (on) ++tour.step;
}

// From the bubble to the middle of what it is about.
void draw_tip(ImVec2 at, bool upwards) {
  const float long_way = points(tip), half = 0.7F * long_way;
  const ImVec2 a = upwards ? ImVec2{at.x - half, at.y + long_way} : ImVec2{at.x + long_way, at.y - half};
  const ImVec2 b = upwards ? ImVec2{at.x + half, at.y + long_way} : ImVec2{at.x + long_way, at.y + half};
  ImGui::GetForegroundDrawList()->AddTriangleFilled(at, a, b, ImGui::GetColorU32(ImGuiCol_CheckMark));
}

}  // namespace

std::string_view tour_target(const Tour& tour) { return tour.wanted ? stop_of(tour).target : std::string_view(); }

void tour_bubble(Sheet& sheet, float panel_right) {
  const Tour& tour = sheet.memory.tour;
  if (!tour.wanted) return;
  const Stop& stop = stop_of(tour);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float edge = points(margin), width = std::min(points(bubble_width), display.x - 2.0F * edge);
  const bool beside = panel_right + points(gap) + width + edge <= display.x;
  const Box& box = tour.target;
  if (stop.target.empty()) {
    const float middle = beside ? (panel_right + display.x) * 0.5F : display.x * 0.5F;
    begin_bubble({middle, display.y * height_of_first}, {0.5F, 0.5F}, width);
  } else if (beside) {
    const float y = std::clamp((box.top + box.bottom) * 0.5F, edge, display.y - edge);
    const bool low = y > display.y * 0.6F;
    const float lift = points(20.0F);
    begin_bubble({panel_right + points(gap), low ? y + lift : std::max(edge, y - lift)}, {0.0F, low ? 1.0F : 0.0F},
                 width);
    draw_tip({panel_right + points(gap - tip), y}, false);
  } else {
    const float x = (box.left + box.right) * 0.5F, y = box.bottom + points(gap);
    begin_bubble({std::clamp(x - 0.5F * width, edge, display.x - edge - width), y}, {0.0F, 0.0F}, width);
    draw_tip({x, y - points(tip)}, true);
  }
  contents(sheet, stop);
  ImGui::End();
}

}  // namespace terrella
