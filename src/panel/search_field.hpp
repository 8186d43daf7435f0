// The field in which parameters are searched.
#pragma once

#include "panel/sheet.hpp"

namespace terrella {

// Escape clears it, and so does a button beside the text.
void search_field(Sheet& sheet);

}  // namespace terrella
