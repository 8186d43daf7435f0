// Where the panel lies: at the left edge, or as a sheet at the bottom, under the planet.
#pragma once

#include "panel/memory.hpp"

namespace terrella {

// Begins the panel's window; end it with end_panel_window(). Returns whether anything of it can be seen.
bool begin_panel_window(PanelPlace place);
void end_panel_window();

// What scrolls: all of a panel at the left edge, of a sheet only what lies below its first row, which stays in reach.
// end_rows() always belongs to it.
void begin_rows(PanelPlace place);
void end_rows(PanelPlace place);

// Height (pixels) of the window's lower edge that an unfolded sheet hides; 0 at the left edge.
float height_of_sheet(PanelPlace place);

}  // namespace terrella
