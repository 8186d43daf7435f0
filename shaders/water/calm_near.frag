// The same from close to a shore.
#include "smooth_water.glsl"
#include "shore_near.glsl"
#include "water_from_air.glsl"
#include "mirror_of_land.glsl"
