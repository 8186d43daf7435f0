// The icosphere's ground where its map is as fine as the pixels.
#include "ground_surface.glsl"

void main() {
  vec3 up = normalize(surface_position());
  GroundAt ground = ground_at(textureLod(ground_map, up, levels.z), up);
  emit_ground(surface_from_eye, ground, map_rise(ground), 0.0);
}
