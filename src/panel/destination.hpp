// Where to fly, as people type it: "47.5, 8.2, 3 km".
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "scene/destination.hpp"

namespace terrella {

// Latitude, longitude and, if one likes, altitude, with commas (or semicolons) between them. N, S, E and W are
// understood, and units of length as read_quantity does; altitude: m, in whose unit a bare number counts. A sentence
// where it is not that.
std::variant<Destination, std::string> read_destination(std::string_view typed, double altitude);

}  // namespace terrella
