// A text field that takes the place of a slider while someone types a number.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "panel/memory.hpp"

namespace terrella {

void start_typing(Typing& typing, std::string_view path, const std::string& text);

// The field. When the typing ends (Enter, a click elsewhere) it gives the text, if that is another than at first;
// Escape ends it with the first text. Afterwards typing.path is empty.
std::optional<std::string> typing_field(Typing& typing);

}  // namespace terrella
