// The shell of clouds, lit by the sun through itself, seen from above and from below.
#include "scene_light.glsl"
#include "output.glsl"

in vec3 surface_from_eye;

void main() {
  vec3 up = normalize(eye_position() + surface_from_eye);
  float noise = cloud_noise(up);
  float thickness = cloud_thickness(noise, clouds_coverage, clouds_softness);
  if (thickness <= 0.0) discard;
  vec3 to_eye = -normalize(surface_from_eye);
  vec3 sun = sun_direction.xyz;
  float climb = dot(up, sun);
  // The cloud is as high as it is thick: what rises towards the sun shades what lies behind it.
  vec3 toward = sun - climb * up;
  float reach = clouds_thickness / max(climb, 0.2);
  float rise = 1.3 * (cloud_noise(normalize(up + reach * toward)) - noise);
  float from_below = dot(up, to_eye) < 0.0 ? 1.5 * thickness : 0.0;
  float depth = max(0.5 + 2.6 * rise, 0.0) + from_below;
  float self_shade = mix(1.0, exp(-depth) * 1.25, clouds_shadow);
  LightAt at = light_at(up, clouds_height);
  vec3 sunlit = at.sun * (wrap_diffuse(climb, 0.25) * self_shade);
  vec3 light = clouds_color.rgb * (sunlit + 1.6 * skylight(at, up)) * 0.5;
  // A shell seen along its edge would end in a line.
  float edge = smoothstep(0.0, 0.16, abs(dot(up, to_eye)));
  float opacity = clouds_density * thickness * edge;
  emit_veil(through_air(light, at, surface_from_eye) * opacity, opacity);
}
