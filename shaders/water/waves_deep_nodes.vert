// Over ground so deep that it holds no waves back.
#include "wavy_vertex.glsl"

WaveSum waves_at_vertex(WaveSum sum, Frame f) { return sum; }
