// What of a panel another program needs to go on with it where it is (base/named_lines.hpp).
#pragma once

#include <string_view>

#include "base/named_lines.hpp"
#include "panel/memory.hpp"

namespace terrella {

// Habits, what is locked and searched for, how far it is scrolled, the way to a preset, the size of pictures, and
// whether the keyboard is there.
void add_state(const PanelMemory& memory, NamedLines& lines);

// Lines of other names are passed over.
void take_state(PanelMemory& memory, std::string_view text);

}  // namespace terrella
