#include "wavy_vertex.glsl"
#include "felt_ground.glsl"

WaveSum waves_at_vertex(WaveSum sum, Frame f) { return held_ashore(sum, f, -node_height.x, node_slope.xyz, sea.w); }
