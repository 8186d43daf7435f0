#pragma once

#include <span>
#include <string>
#include <string_view>

#include "probe/function.hpp"

namespace terrella::probe {

// Whether an object holds just what is declared, in kind, number and range. Returns a sentence on the first thing that
// is wrong, or nothing. whole: how the sentence names the object, "grid_offset".
std::string trouble_with(const Json& object, std::span<const Arg> declared, std::string_view whole);

// A sentence where an argument is so large or so small that single precision does not hold its square.
std::string trouble_with_squares(const Json& object, std::span<const Arg> declared);

// The same arguments as a vertex or a pixel is told them: all that the host does not keep to itself as floats, and on
// the GPU 0 for what drivers take for it, unless that is out of range. None may be larger than a float can be.
Json as_told(const Json& object, std::span<const Arg> declared, Precision precision);

// A range in words: "more than 0".
std::string range_in_words(const Range& range);

}  // namespace terrella::probe
