// The icosphere's ground where its map is as fine as the pixels.
#include "icosphere_ground.glsl"
#include "ground_from_air.glsl"
