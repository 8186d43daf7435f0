// The shadow of the rings as a veil before all that it falls on: of the light there is little beside the sun's.
#include "scene_block.glsl"
#include "output.glsl"
#include "lib/rings.glsl"

in vec3 surface_from_eye;

void main() {
  vec3 place = eye_position() + surface_from_eye;
  vec3 sun = sun_direction.xyz;
  float shade = 1.0 - ring_shade(place, sun, rings_inner, rings_outer, rings_density, ring_shadow_blur, uint(rings_seed));
  float by_day = smoothstep(0.0, 0.15, dot(normalize(place), sun));
  emit_veil(vec3(0.0), 0.85 * shade * by_day);
}
