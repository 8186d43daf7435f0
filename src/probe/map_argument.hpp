// A map of heights as an argument.
#pragma once

#include "probe/table.hpp"

namespace terrella::probe {

// Columns, rows, and their heights (0..1) row after row, as base/height_map.hpp has them. In every precision a map
// holds heights as floats.
Arg map_argument();

// The map of arguments that hold it; a sentence where its size is not allowed or its heights are not as many.
Result<SharedHeightMap> map_of_argument(const Json& args);

// A small one, of hills or of heights by chance, or in between.
Json made_up_map(Random& random);

}  // namespace terrella::probe
