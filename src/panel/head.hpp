// The top of the panel: what concerns the scene as a whole.
#pragma once

#include "panel/sheet.hpp"

namespace terrella {

// Undo, redo, help, full screen where there is one, and fold.
void title_row(Sheet& sheet);
// List of presets, buttons.
void head_section(Sheet& sheet);
// All there is of a folded panel.
void folded_section(Sheet& sheet);
// Pause, and the planet's time.
void clock_section(Sheet& sheet);

}  // namespace terrella
