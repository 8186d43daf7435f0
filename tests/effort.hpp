// How much a test does. `make test` takes a part of what takes long, so that it ends within the hour; all of it is done
// where TERRELLA_WHOLE is set (`make test-whole`). Under sanitizers, where everything takes five to ten times as long,
// tests look for what sanitizers find, on small pictures, and leave measuring to the other build.
#pragma once

#include <cstdlib>

namespace terrella::test {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

inline constexpr const char* too_long_sanitized = "takes long under sanitizers, and other tests run the same code";

// One of three numbers: of all that can be done, of what is done as a rule, and of what is done under sanitizers.
inline int by_effort(int all, int usual, int under_sanitizers) {
  if (sanitized) return under_sanitizers;
  return std::getenv("TERRELLA_WHOLE") != nullptr ? all : usual;
}

inline int by_effort(int all, int usual) { return by_effort(all, usual, usual); }

// Whether measured figures are printed (TERRELLA_PRINT=1).
inline bool prints() { return std::getenv("TERRELLA_PRINT") != nullptr; }

}  // namespace terrella::test
