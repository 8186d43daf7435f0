// Fills a face of the map of the ground.
#include "baked_ground.glsl"

void main() {
  vec3 direction = normalize(cube_direction);
  emit_baked(terrain_height_at(direction, scene_terrain(), texel_angle), direction);
}
