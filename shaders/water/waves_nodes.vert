#include "wavy_vertex.glsl"

WaveSum waves_at_vertex(WaveSum sum, Frame f) { return held_in_frame(sum, f, -node_height.x, node_slope.xyz, sea.w); }
