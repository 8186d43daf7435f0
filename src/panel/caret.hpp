// The place where text is typed.
#pragma once

#include "panel/memory.hpp"

namespace terrella {

// Scrolls it into the middle of what scrolls it when the window has become lower, as it does where a keyboard on the
// screen takes its lower half. After all widgets of a frame.
void keep_caret_in_sight(Caret& caret);

}  // namespace terrella
