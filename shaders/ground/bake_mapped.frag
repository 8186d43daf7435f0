// Fills a face of the map of the ground where terrain.map tells the continents.
#include "baked_ground.glsl"
#include "lib/mapped_heights.glsl"

uniform highp sampler2D height_map;

void main() {
  vec3 direction = normalize(cube_direction);
  emit_baked(mapped_height_at(direction, scene_terrain(), height_map, texel_angle), direction);
}
