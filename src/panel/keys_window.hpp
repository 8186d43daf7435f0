// The list of all keys and movements of the mouse, in the middle of the picture.
#pragma once

#include "panel/sheet.hpp"

namespace terrella {

// Nothing unless memory.keys_shown; Escape and its button end that.
void keys_window(Sheet& sheet);

}  // namespace terrella
