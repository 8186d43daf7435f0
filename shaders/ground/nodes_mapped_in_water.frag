// The same with continents of a map.
#include "node_map.glsl"
#include "nodes_ground.glsl"
#include "ground_in_still_water.glsl"
