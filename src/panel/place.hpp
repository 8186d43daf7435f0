// Where the panel lies: at the left edge, or as a sheet at the bottom, under the planet.
#pragma once

#include "panel/memory.hpp"

namespace terrella {

// Windows lower than that have little room: points.
inline constexpr float kLowWindow = 500.0F;

// Begins the panel's window; end it with end_panel_window(). Returns whether anything of it can be seen.
bool begin_panel_window(PanelPlace place);
void end_panel_window();

// What scrolls: all of a panel at the left edge, of a sheet only what lies below its first row, which stays in reach.
// end_rows() always belongs to it.
void begin_rows(PanelPlace place);
void end_rows(PanelPlace place);

// What an unfolded panel hides: a sheet the window's lower edge, one at the left as much as it is wide if that is more
// than a quarter of the window, else nothing worth to make room for.
Covered covered_by(PanelPlace place);

}  // namespace terrella
