// The same under clouds.
#include "smooth_water.glsl"
#include "deep_nodes.glsl"
#include "water_from_air.glsl"
#include "mirror_of_clouds.glsl"
