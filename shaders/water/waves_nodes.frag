// A sea of waves over a ground of nodes.
#include "node_no_map.glsl"
#include "shore_nodes.glsl"
#include "wavy_shore.glsl"
#include "water_from_air.glsl"
#include "mirror_of_land.glsl"
