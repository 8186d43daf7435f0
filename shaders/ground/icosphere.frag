// The icosphere's ground where its map is as fine as the pixels.
#include "ground_surface.glsl"

void main() {
  vec4 map = textureLod(ground_map, normalize(surface_position()), levels.z);
  emit_ground(map, map.xyz);
}
