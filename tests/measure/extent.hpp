// How much the tests drive to: under sanitizers, where all takes ten times as long, a part of it.
#pragma once

#include "effort.hpp"
#include "measure/cases.hpp"

namespace terrella::test {

inline constexpr Extent extent = sanitized ? Extent::sample : Extent::quick;

}  // namespace terrella::test
