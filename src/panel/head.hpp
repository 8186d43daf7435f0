// The top of the panel: what concerns the scene as a whole.
#pragma once

#include "panel/sheet.hpp"

namespace terrella {

// Title, list of presets, buttons.
void head_section(Sheet& sheet);
// All there is of a folded panel.
void folded_section(Sheet& sheet);
// Pause, and the planet's time.
void clock_section(Sheet& sheet);

}  // namespace terrella
