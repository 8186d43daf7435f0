// The shell of clouds, lit by the sun through itself, seen from above and from below: what its ways of finding the noise
// have in common.
#include "scene_light.glsl"
#include "output.glsl"

in vec3 surface_from_eye;

// What there is of clouds at a place of the shell.
struct CloudAt {
  vec3 up;      // unit, from the planet's centre to the place
  float climb;  // sine of the sun's height
  vec3 toward;  // the sun's direction along the shell
  float reach;  // how far along it the light has come that arrives through one depth of the layer, rad
  float noise;  // that clouds are made from
  float rise;   // by how much more there is of it towards the sun
};

// As far as the map tells.
CloudAt cloud_of_map() {
  CloudAt at;
  at.up = normalize(eye_position() + surface_from_eye);
  at.climb = dot(at.up, sun_direction.xyz);
  at.toward = sun_direction.xyz - at.climb * at.up;
  at.reach = clouds_thickness / max(at.climb, 0.2);
  at.noise = cloud_noise(at.up);
  at.rise = cloud_noise(normalize(at.up + at.reach * at.toward)) - at.noise;
  return at;
}

void emit_clouds(CloudAt cloud) {
  float thickness = cloud_thickness(cloud.noise, clouds_coverage, clouds_softness);
  if (thickness <= 0.0) discard;
  vec3 up = cloud.up;
  vec3 to_eye = -normalize(surface_from_eye);
  // The cloud is as high as it is thick: what rises towards the sun shades what lies behind it.
  float from_below = dot(up, to_eye) < 0.0 ? 1.5 * thickness : 0.0;
  float depth = max(0.7 + 10.0 * cloud.rise, 0.0) + from_below;
  float self_shade = mix(1.0, exp(-depth) * 1.25, clouds_shadow);
  LightAt at = light_at(up, clouds_height);
  vec3 sunlit = at.sun * (wrap_diffuse(cloud.climb, 0.25) * self_shade);
  vec3 light = clouds_color.rgb * (sunlit + 1.6 * skylight(at, up)) * 0.5;
  // A shell seen along its edge would end in a line.
  float edge = smoothstep(0.0, 0.16, abs(dot(up, to_eye)));
  float opacity = clouds_density * thickness * edge;
  emit_veil(through_air(light, at, surface_from_eye) * opacity, opacity);
}
