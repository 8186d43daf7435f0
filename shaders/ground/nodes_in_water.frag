// The ground of nodes where the eye is under water that lies still.
#include "node_no_map.glsl"
#include "nodes_ground.glsl"
#include "ground_in_still_water.glsl"
