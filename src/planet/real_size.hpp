// Whether this build draws planets of real size (CMake's TERRELLA_REAL_SIZE): what only they need is left out where
// not.
#pragma once

namespace terrella {

#ifdef TERRELLA_REAL_SIZE
inline constexpr bool has_real_size = true;
#else
inline constexpr bool has_real_size = false;
#endif

}  // namespace terrella
