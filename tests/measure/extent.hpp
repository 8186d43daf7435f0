// How much the tests drive to: under sanitizers, where all takes ten times as long, a part of it.
#pragma once

#include "measure/cases.hpp"

namespace terrella::test {

#ifdef __SANITIZE_ADDRESS__
inline constexpr Extent extent = Extent::sample;
#else
inline constexpr Extent extent = Extent::quick;
#endif

}  // namespace terrella::test
