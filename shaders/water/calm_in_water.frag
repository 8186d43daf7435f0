// The same where the eye is under water.
#include "smooth_water.glsl"
#include "shore_far.glsl"
#include "water_from_both.glsl"
