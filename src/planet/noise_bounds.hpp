// What the noise of shaders/lib/noise.glsl never passes, in cells (tests/laws/bounds_test.cpp measures it).
#pragma once

namespace terrella {

inline constexpr double noise_slope = 6.5;       // how steep it is
inline constexpr double noise_curvature = 48.0;  // how fast its slope changes
inline constexpr double noise_range = 1.02;      // how far it is from 0

}  // namespace terrella
