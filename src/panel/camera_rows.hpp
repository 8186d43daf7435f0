// What stands above the parameters of the group camera: how hands move it, and where to.
#pragma once

#include "panel/sheet.hpp"

namespace terrella {

void camera_rows(Sheet& sheet);

}  // namespace terrella
