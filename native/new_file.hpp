#pragma once

#include <string>
#include <string_view>

#include "base/result.hpp"

namespace terrella {

// Writes a file of a name that is not taken yet into the working folder: planet.json, planet-2.json, … Returns the
// name.
Result<std::string> save_new_file(const std::string& stem, const std::string& extension, std::string_view bytes);

}  // namespace terrella
