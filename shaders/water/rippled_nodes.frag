// A calm sea with ripples, over a ground of nodes.
#include "rippled_water.glsl"
#include "shore_nodes.glsl"
