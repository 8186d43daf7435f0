// Land on the water's mesh where the map of the ground is as fine as pixels.
#include "water_surface.glsl"

void emit_land(vec3 up) {
  emit_ground(ground_at(textureLod(ground_map, up, levels.z), up), 0.0);
}
