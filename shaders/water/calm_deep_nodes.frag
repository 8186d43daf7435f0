// A calm sea whose ripples are too small to be seen, over deep nodes.
#include "smooth_water.glsl"
#include "deep_nodes.glsl"
#include "water_from_air.glsl"
#include "mirror_of_sky.glsl"
