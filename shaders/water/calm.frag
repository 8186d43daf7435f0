// A calm sea whose ripples are too small to be seen: they only widen the glitter.
#include "smooth_water.glsl"
#include "shore_far.glsl"
#include "water_from_air.glsl"
#include "mirror_of_sky.glsl"
