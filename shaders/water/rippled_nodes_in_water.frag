// The same where the eye is under water.
#include "rippled_water.glsl"
#include "node_no_map.glsl"
#include "shore_nodes.glsl"
#include "water_from_both.glsl"
