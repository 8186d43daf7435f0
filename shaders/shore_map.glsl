// What lies under the water by the map of the ground.
#include "water_surface.glsl"

float depth_below(vec3 up) { return -textureLod(ground_map, up, levels.z).w; }

GroundAt ground_below(vec3 up) { return ground_at(textureLod(ground_map, up, levels.z), up); }
