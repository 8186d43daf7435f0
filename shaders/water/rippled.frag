// A calm sea with ripples of flow noise; close to it each layer carries a finer one.
#include "rippled_water.glsl"
#include "shore_far.glsl"
#include "water_from_air.glsl"
#include "mirror_of_sky.glsl"
