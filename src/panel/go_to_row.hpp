// Where the camera is, in one line, and where to type another place for it to fly to.
#pragma once

#include "panel/sheet.hpp"

namespace terrella {

void go_to_row(Sheet& sheet);

}  // namespace terrella
