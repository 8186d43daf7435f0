// The same under clouds.
#include "smooth_water.glsl"
#include "shore_far.glsl"
#include "water_from_air.glsl"
#include "mirror_of_clouds.glsl"
