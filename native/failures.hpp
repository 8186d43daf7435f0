// How a command ends that could not do what was asked: sentences on standard error, and an exit code.
#pragma once

#include <cstdio>
#include <string>

#include "base/issues.hpp"

namespace terrella {

// 2: the input was wrong.
inline int report_bad_input(const Issues& issues) {
  for (const std::string& sentence : issues.sentences()) std::fprintf(stderr, "%s\n", sentence.c_str());
  return 2;
}

// 1: this machine could not.
inline int report_failure(const std::string& sentence) {
  std::fprintf(stderr, "%s\n", sentence.c_str());
  return 1;
}

}  // namespace terrella
