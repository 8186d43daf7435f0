// Square buttons with a drawn sign, as wide as the reset button.
#pragma once

namespace terrella {

// A die.
bool random_button(const char* id);

// A padlock, closed or open. Not drawn unless shown; it can be pressed all the same, as a finger comes without
// hovering.
bool lock_button(const char* id, bool locked, bool shown);

}  // namespace terrella
