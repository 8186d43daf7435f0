// A sea of waves over a ground of nodes with continents of a map.
#include "node_map.glsl"
#include "shore_nodes.glsl"
#include "wavy_shore.glsl"
#include "water_from_air.glsl"
#include "mirror_of_land.glsl"
