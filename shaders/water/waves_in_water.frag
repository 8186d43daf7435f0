// The same where the eye is under water.
#include "wavy_water.glsl"
#include "shore_far.glsl"
#include "water_from_both.glsl"
