// Requests that nobody means well with.
#pragma once

#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "probe/function.hpp"

namespace terrella::probe::test {

// Puts numbers of any size in the place of some of those within a value.
inline void make_extreme(Json& value, Random& random) {
  constexpr double sizes[] = {0.0,    5e-324, 1e-300, 1e-45, 1e-40, 1.2e-38, 1e-30, 1e-19, 1e-7,  1.0,      24.0,
                              6.36e6, 1e18,   1e19,   3e34,  1e38,  3.41e38, 1e154, 1e155, 1e300, 1.797e308};
  if (value.is_number()) {
    if (random.chance(0.3)) value = (random.chance(0.3) ? -1.0 : 1.0) * sizes[random.below(std::size(sizes))];
  } else if (value.is_structured()) {
    for (Json& one : value) make_extreme(one, random);
  }
}

// Well formed requests of every function, with arguments of any size.
inline std::vector<std::string> extreme_requests(int of_each, std::string_view precision, unsigned seed) {
  std::vector<std::string> lines;
  for (const Function& function : functions()) {
    Random random(seed);
    for (int i = 0; i < of_each; ++i) {
      Json args = function.random(random);
      make_extreme(args, random);
      lines.push_back(
          Json{{"id", lines.size()}, {"fn", function.name}, {"args", args}, {"precision", precision}}.dump());
    }
  }
  return lines;
}

// The same, broken: with other bytes in some places, words that are no JSON, or the end missing.
inline std::vector<std::string> garbled(std::vector<std::string> lines, unsigned seed) {
  Random random(seed);
  constexpr std::string_view words[] = {"NaN", "-Infinity", "1e999",    "null", "\"", "\\",
                                        "[",   "}",         "{\"id\":", "\xff", ""};
  for (std::string& line : lines) {
    const std::size_t place = random.below(line.size());
    switch (random.below(4)) {
      case 0: line.erase(place); break;
      case 1: line[place] = static_cast<char>(1 + random.below(255)); break;
      case 2: line.insert(place, words[random.below(std::size(words))]); break;
      default: line.erase(place, random.below(20)); break;
    }
    for (char& c : line) {
      if (c == '\n') c = ' ';
    }
  }
  return lines;
}

}  // namespace terrella::probe::test
