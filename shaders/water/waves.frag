// A sea of trochoidal waves; the normal is exact at every pixel, whatever the mesh carries.
#include "wavy_water.glsl"
#include "shore_far.glsl"
#include "water_from_air.glsl"
#include "mirror_of_sky.glsl"
