// The same where land stands in its mirror.
#include "smooth_water.glsl"
#include "deep_nodes.glsl"
#include "water_from_air.glsl"
#include "mirror_of_land.glsl"
