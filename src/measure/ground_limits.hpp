// What a ground of real size may cost.
#pragma once

#include <string>
#include <vector>

#include "measure/ground_table.hpp"

namespace terrella {

// Of every frame, on one core, ms.
double cpu_ms(const GroundRow& row);

// A sentence for each limit that a row breaks by itself, whatever other models do.
std::vector<std::string> broken_by(const GroundRow& row);

// The same of all rows, and for each view that no model draws with as few triangles as the best is to.
std::vector<std::string> broken_limits(const GroundTable& table);

}  // namespace terrella
