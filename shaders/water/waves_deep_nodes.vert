// Over ground so deep that it holds no waves back.
#include "wavy_vertex.glsl"
#include "no_felt_ground.glsl"

WaveSum waves_at_vertex(WaveSum sum, Frame f) { return sum; }
