// The icosphere's ground so near that pixels are finer than its map.
#include "icosphere_near_ground.glsl"
#include "ground_from_air.glsl"
