#include "native/progress_bar.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include "native/progress_lines.hpp"

namespace terrella {
namespace {

void draw_bar(const char* what, double part) {
  constexpr int width = 30;
  const double done = std::clamp(part, 0.0, 1.0);
  const std::string bar(static_cast<std::size_t>(done * width), '#');
  std::fprintf(stderr, "\r%-24s [%-*s] %3d %%%s", what, width, bar.c_str(), static_cast<int>(100.0 * done),
               done >= 1.0 ? "\n" : "");
}

void write_line(const char* what, double part) {
  static ProgressLines lines;
  const std::chrono::duration<double> now = std::chrono::steady_clock::now().time_since_epoch();
  if (const auto line = lines.line(what, part, now.count())) std::fprintf(stderr, "%s\n", line->c_str());
}

}  // namespace

void show_progress(const char* what, double part) {
  static const bool terminal = isatty(STDERR_FILENO) != 0;
  terminal ? draw_bar(what, part) : write_line(what, part);
}

}  // namespace terrella
