// What lies under the water by the map of the ground.
#include "water_bottom.glsl"

float depth_below(vec3 up) { return -textureLod(ground_map, up, levels.z).w; }

float layer_rise(GroundAt ground) { return map_rise(ground); }

GroundAt ground_aside(vec3 aside, vec3 up) {
  vec3 direction = normalize(up + aside);
  return ground_at(textureLod(ground_map, direction, levels.z), direction);
}
