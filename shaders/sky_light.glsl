// How much of the light of the sky behind reaches the eye.
#include "scene_block.glsl"
#include "frame_block.glsl"
#include "lib/air.glsl"

// 0..1: hidden by the planet's air; seen from within the air, by the daylight. direction: unit, away from the eye.
float sky_shown(vec3 direction) {
  if (ripple.z == 0.0) return 1.0;
  vec3 eye = eye_position();
  vec3 up = normalize(eye);
  float within = 1.0 - smoothstep(0.9 * air_height, air_height, eye_high.w);
  float by_daylight = exp(-6.0 * air_density * smoothstep(-0.25, 0.1, dot(up, sun_direction.xyz))) *
                      smoothstep(0.0, 0.3, dot(up, direction));
  return mix(sky_past_air(eye, direction, 1.0 + air_height), by_daylight, within);
}
