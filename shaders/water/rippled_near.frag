// The same from close to a shore.
#include "rippled_water.glsl"
#include "shore_near.glsl"
