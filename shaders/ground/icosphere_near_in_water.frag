// The same where the eye is under water.
#include "icosphere_near_ground.glsl"
#include "ground_in_still_water.glsl"
