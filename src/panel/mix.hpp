// The scene on its way to another preset: a list of presets and a slider from 0 to 100 %.
#pragma once

#include "panel/sheet.hpp"

namespace terrella {

// Nothing unless memory.mix.shown.
void mix_section(Sheet& sheet);

}  // namespace terrella
