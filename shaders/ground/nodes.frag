// The ground of nodes.
#include "node_no_map.glsl"
#include "nodes_ground.glsl"
#include "ground_from_air.glsl"
