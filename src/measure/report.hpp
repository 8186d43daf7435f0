// What was measured at the extremes, for programs and for people.
#pragma once

#include <string>

#include "measure/extremes.hpp"

namespace terrella {

// One JSON object; docs/command_line.md tells its members. Infinite errors are null.
std::string extremes_json(const ExtremesReport& report);

// A whole page that asks nothing of any host.
std::string extremes_page(const ExtremesReport& report);

}  // namespace terrella
