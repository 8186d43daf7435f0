// What a texel of the map of the ground holds; ground_map.glsl says what that is.
#include "scene_terrain.glsl"

uniform float texel_angle;

in vec3 cube_direction;
out vec4 fragment;

void emit_baked(Height ground, vec3 direction) {
  vec3 tangential = ground.gradient - dot(ground.gradient, direction) * direction;
  fragment = vec4(tangential + ground.openness * direction, ground.value - water_level);
}
