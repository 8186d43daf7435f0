// The same where the eye is under water.
#include "node_no_map.glsl"
#include "shore_nodes.glsl"
#include "wavy_shore.glsl"
#include "water_from_both.glsl"
