#include "base/check.hpp"

#include <cstdio>
#include <cstdlib>

namespace terrella {

void fail_check(const char* file, int line, const char* condition, const std::string& message) {
  std::fprintf(stderr, "%s:%d: CHECK(%s) failed%s%s\n", file, line, condition, message.empty() ? "" : ": ",
               message.c_str());
  std::abort();
}

}  // namespace terrella
