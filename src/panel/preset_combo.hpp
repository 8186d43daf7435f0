// A list of all presets, each with its picture, that opens under the chosen one.
#pragma once

#include <string_view>

#include "panel/sheet.hpp"

namespace terrella {

// Returns the preset that was picked in this frame, or null. name: of the list in the places of widgets, and of each
// entry before its preset's name; title, help: of the closed list, help being a sentence; width: pixels.
const Preset* preset_combo(Sheet& sheet, std::string_view name, const Preset& chosen, const std::string& title,
                           const std::string& help, float width);

}  // namespace terrella
