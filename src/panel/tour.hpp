// Four bubbles that show a newcomer what can be done, one at a time.
#pragma once

#include <string_view>

#include "panel/sheet.hpp"

namespace terrella {

// The widget to which the bubble now points; empty where it points to none.
std::string_view tour_target(const Tour& tour);

// Scrolls the widget that was drawn last into sight, once, if it is the target, and notes where it is.
void note_tour_target(Tour& tour, std::string_view name);

// Beside the panel, which ends at panel_right, in pixels; over a sheet, or below its target where there is no room. A
// folded panel has only the first, which is about the planet. Nothing unless memory.tour.wanted, nor beside the list of
// keys; its buttons lead on and end that, and so does Escape.
void tour_bubble(Sheet& sheet, float panel_right);

}  // namespace terrella
