// The shell of clouds, lit by the sun through itself, seen from above and from below: what its ways of finding the noise
// have in common.
#include "scene_light.glsl"
#include "output.glsl"

in vec3 surface_from_eye;

// How far along the shell the light has come that arrives through one depth of the layer, rad. climb: sine of the sun's
// height.
float cloud_reach(float climb) {
  return clouds_thickness / max(climb, 0.2);
}

// By how much more noise there is towards the sun than at a place, as far as the map tells. toward: the sun's direction
// along the shell.
float noise_rise(vec3 up, vec3 toward, float reach, float noise) {
  return cloud_noise(normalize(up + reach * toward)) - noise;
}

// noise: that clouds are made from, at the place; rise: by how much more there is of it towards the sun.
void emit_clouds(vec3 up, float noise, float rise) {
  float thickness = cloud_thickness(noise, clouds_coverage, clouds_softness);
  if (thickness <= 0.0) discard;
  vec3 to_eye = -normalize(surface_from_eye);
  float climb = dot(up, sun_direction.xyz);
  // The cloud is as high as it is thick: what rises towards the sun shades what lies behind it.
  float from_below = dot(up, to_eye) < 0.0 ? 1.5 * thickness : 0.0;
  float depth = max(0.7 + 10.0 * rise, 0.0) + from_below;
  float self_shade = mix(1.0, exp(-depth) * 1.25, clouds_shadow);
  LightAt at = light_at(up, clouds_height);
  vec3 sunlit = at.sun * (wrap_diffuse(climb, 0.25) * self_shade);
  vec3 light = clouds_color.rgb * (sunlit + 1.6 * skylight(at, up)) * 0.5;
  // A shell seen along its edge would end in a line.
  float edge = smoothstep(0.0, 0.16, abs(dot(up, to_eye)));
  float opacity = clouds_density * thickness * edge;
  emit_veil(through_air(light, at, surface_from_eye) * opacity, opacity);
}
