// What stands above the parameters of the group quality: its presets, and what holding a time costs.
#pragma once

#include "panel/sheet.hpp"

namespace terrella {

void quality_rows(Sheet& sheet);

}  // namespace terrella
