// Land on the water's mesh where the map of the ground is as fine as pixels.
#include "shore_map.glsl"

void refine_land(inout GroundAt land, inout float grain, vec3 up, float depth) {}
