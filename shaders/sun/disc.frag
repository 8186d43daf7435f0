#include "scene_light.glsl"
#include "output.glsl"
#include "lib/sun.glsl"

uniform float radius;  // tangent of the sun's apparent radius
uniform float reach;   // as in the vertex stage
uniform float disc;    // brightness of each
uniform float glare;

in vec2 sun_place;

// Sunlight as it comes to the eye: through the air around the eye, or, from outside, through that along the planet's limb.
vec3 sunlight_at_eye() {
  vec3 eye = eye_position(), sun = sun_direction.xyz;
  float top = max(air_height, 1.0e-6);
  float within = 1.0 - smoothstep(0.5 * top, top, eye_high.w);
  float along = dot(eye, sun);
  float lowest = length(eye - along * sun) - 1.0;
  float grazing = along < 0.0 ? 1.0 - clamp(lowest / top, 0.0, 1.0) : 0.0;
  vec3 past_limb = sun_light.rgb * mix(vec3(1.0), air_dusk_color.rgb, 0.8 * ripple.z * air_density * grazing * grazing);
  return mix(past_limb, light_at(normalize(eye), eye_high.w).sun, within);
}

void main() {
  float away = length(sun_place);
  float shape = disc * disc_of_sun(away, radius, ray_forward.w) + glare * glare_of_sun(away, radius, reach);
  emit_veil(sunlight_at_eye() * shape, 0.0);
}
