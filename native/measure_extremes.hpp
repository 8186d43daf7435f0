#pragma once

#include <string>

namespace terrella {

// `terrella measure --extremes`: measures and writes; returns what went wrong or does not hold, or nothing.
std::string measure_extremes(const std::string& folder, bool quick);

}  // namespace terrella
