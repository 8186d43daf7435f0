// One parameter's line in the panel: its name, the widget that fits its type, and a way back to the preset's value.
#pragma once

#include <string>

#include "panel/sheet.hpp"

namespace terrella {

// What stands at the left of a row; what is drawn next stands beside it. Returns the width left for it, pixels.
float row_label(const std::string& text);

void parameter_row(Sheet& sheet, const Parameter& parameter);

}  // namespace terrella
