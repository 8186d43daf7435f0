#pragma once

namespace terrella::test {

// By how much the nearest float may be off, relatively: 2^-24.
inline constexpr double roundoff = 0x1p-24;

}  // namespace terrella::test
