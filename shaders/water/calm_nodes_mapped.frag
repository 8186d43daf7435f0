// A calm sea whose ripples are too small to be seen, over a ground of nodes with continents of a map.
#include "smooth_water.glsl"
#include "node_map.glsl"
#include "shore_nodes.glsl"
#include "water_from_air.glsl"
#include "mirror_of_land.glsl"
