// A map of the planet: where the camera is and faces, where the sun shines; a press leads there.
#pragma once

#include "panel/sheet.hpp"

namespace terrella {

void map_view(Sheet& sheet);

}  // namespace terrella
