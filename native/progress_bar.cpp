#include "native/progress_bar.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace terrella {

void show_progress(const char* what, double part) {
  static const bool terminal = isatty(STDERR_FILENO) != 0;
  if (!terminal) return;
  constexpr int width = 30;
  const double done = std::clamp(part, 0.0, 1.0);
  const std::string bar(static_cast<std::size_t>(done * width), '#');
  std::fprintf(stderr, "\r%-24s [%-*s] %3d %%%s", what, width, bar.c_str(), static_cast<int>(100.0 * done),
               done >= 1.0 ? "\n" : "");
}

}  // namespace terrella
