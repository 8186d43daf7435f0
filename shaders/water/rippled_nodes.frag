// A calm sea with ripples, over a ground of nodes.
#include "rippled_water.glsl"
#include "node_no_map.glsl"
#include "shore_nodes.glsl"
#include "water_from_air.glsl"
#include "mirror_of_land.glsl"
