// One line of the probe's input as JSON.
#pragma once

#include <cstddef>
#include <string>

#include "probe/function.hpp"

namespace terrella::probe {

// The longest line that is read, in bytes.
inline constexpr std::size_t kLongestLine = 10'000'000;

struct Line {
  Json request;         // an object where there is no trouble
  Json id;              // null where there is none, or none can be made out
  std::string trouble;  // a sentence on why the line is no request; empty if it is one
};

// A line that is no JSON still tells its id where that can be made out, so that who sent it learns which request
// failed.
Line read_line(const std::string& line);

}  // namespace terrella::probe
