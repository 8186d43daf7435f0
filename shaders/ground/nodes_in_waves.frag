// The ground of nodes where the eye is under waves.
#include "node_no_map.glsl"
#include "nodes_ground.glsl"
#include "ground_in_waves.glsl"
