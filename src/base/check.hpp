#pragma once

#include <string>

#include "base/text.hpp"

// Stops the program at a programmer's error, with file, line, and what is given beside the condition:
//   CHECK(width > 0, "an image of width ", width);
// A user's bad input is not a programmer's error: that gives an Issue.
#define CHECK(condition, ...)   \
  (static_cast<bool>(condition) \
       ? static_cast<void>(0)   \
       : ::terrella::fail_check(__FILE__, __LINE__, #condition, ::terrella::text_of(__VA_ARGS__)))

namespace terrella {

// Prints one line on standard error and aborts.
[[noreturn]] void fail_check(const char* file, int line, const char* condition, const std::string& message);

}  // namespace terrella
