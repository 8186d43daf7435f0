// Four bubbles that show a newcomer what can be done, one at a time.
#pragma once

#include <string_view>

#include "panel/sheet.hpp"

namespace terrella {

// The widget to which the bubble now points; empty where it points to none.
std::string_view tour_target(const Tour& tour);

// Beside the panel, which ends at panel_right, in pixels; below its target where there is no room. Nothing unless
// memory.tour.wanted; its buttons lead on and end that.
void tour_bubble(Sheet& sheet, float panel_right);

}  // namespace terrella
