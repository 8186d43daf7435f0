// One parameter's line in the panel: its name, the widget that fits its type, and a way back to the preset's value.
#pragma once

#include "panel/sheet.hpp"

namespace terrella {

void parameter_row(Sheet& sheet, const Parameter& parameter);

}  // namespace terrella
