// What the panel keeps from one visit to the next, as a line of text.
#pragma once

#include <string>
#include <string_view>

#include "panel/memory.hpp"

namespace terrella {

// The longest text that is worth keeping, in bytes.
inline constexpr std::size_t kLongestHabits = 4096;

// Of who comes for the first time: the tour is still to come.
inline constexpr std::string_view kNewcomersHabits = "tour";

// "folded mix tour terrain waves": whether the panel is folded, whether the mix is shown, whether the tour is not over,
// which sections are open.
std::string habits_of(const PanelMemory& memory);

// Takes on what such a text says; of any other text what words it understands, in any order.
void take_habits(PanelMemory& memory, std::string_view text);

}  // namespace terrella
