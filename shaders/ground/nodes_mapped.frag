// The ground of nodes with continents of a map.
#include "node_map.glsl"
#include "nodes_ground.glsl"
#include "ground_from_air.glsl"
