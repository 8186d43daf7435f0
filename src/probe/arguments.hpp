#pragma once

#include <span>
#include <string>
#include <string_view>

#include "probe/function.hpp"

namespace terrella::probe {

// Whether an object holds just what is declared, in kind, number and range. Returns a sentence on the first thing that
// is wrong, or nothing. whole: how the sentence names the object, "grid_offset".
std::string trouble_with(const Json& object, std::span<const Arg> declared, std::string_view whole);

// A range in words: "more than 0".
std::string range_in_words(const Range& range);

}  // namespace terrella::probe
