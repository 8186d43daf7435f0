// What the panel tells about the picture: what is modelled and why, and what it costs.
#pragma once

#include "panel/sheet.hpp"

namespace terrella {

void decisions_section(const Sheet& sheet);
void statistics_section(const Sheet& sheet);

}  // namespace terrella
