// How long something takes on the wall.
#pragma once

#include <chrono>

namespace terrella {

inline double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace terrella
