// The parameters that a few typed words mean.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/parameters.hpp"

namespace terrella {

// Those in whose path, name, help or group's title every word of a text occurs, whatever its case, in the table's
// order. All of them for a text without words.
std::vector<const Parameter*> parameters_about(std::string_view text);

// The sentence for a text about which there are none, with the name that is most like it.
std::string nothing_about(std::string_view text);

}  // namespace terrella
