// Whether the tests run under sanitizers, where everything takes five to ten times as long: there they look for what
// sanitizers find, on small pictures, and leave measuring to the other build.
#pragma once

namespace terrella::test {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace terrella::test
