// The sections of the panel that open and close under a header.
#pragma once

#include <string>
#include <string_view>

#include "panel/sheet.hpp"

namespace terrella {

// Beside the groups, which are called as in the table.
inline constexpr std::string_view decisions_name = "decisions", statistics_name = "statistics";

// A header, on which other buttons may lie. Returns whether its section is open.
bool section_header(const Sheet& sheet, std::string_view name, std::string_view title);

}  // namespace terrella
