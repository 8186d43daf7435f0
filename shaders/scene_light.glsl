// How the scene's light, air and clouds act on any surface: the formulas of lib fed with the scene's parameters. What
// several surfaces at one place share is computed once (LightAt).
#include "scene_block.glsl"
#include "frame_block.glsl"
#include "lib/air.glsl"
#include "lib/clouds.glsl"

// The noise that clouds are made from, at three moments; cloud_moments weights them.
uniform samplerCube clouds_map;

Air scene_air() {
  Air air;
  air.top = 1.0 + max(air_height, 1.0e-6);
  air.density = air_density;
  air.exponent = air_exponent;
  air.wrap = air_wrap;
  air.color = air_color.rgb;
  air.dusk = air_dusk_color.rgb;
  return air;
}

// A direction as the clouds have it, which drift around the planet.
vec3 drifted(vec3 direction) {
  return vec3(cloud_turn.x * direction.x + cloud_turn.y * direction.y,
              cloud_turn.x * direction.y - cloud_turn.y * direction.x, direction.z);
}

// The noise that clouds are made from, at the frame's time.
float cloud_noise(vec3 direction) {
  // Texels of 10 bits are cheaper to fetch than floats where there is no graphics card.
  return noise_from_map(dot(textureLod(clouds_map, drifted(direction), cloud_turn.z).rgb, cloud_moments.xyz));
}

// Thickness of the clouds over a place, 0..1.
float cloud_over(vec3 direction) {
  return cloud_thickness(cloud_noise(direction), clouds_coverage, clouds_softness);
}

// Part of the sunlight that the clouds leave at a place; all of it above them.
float cloud_shade(vec3 place) {
  if (cloud_turn.w == 0.0 || clouds_shadow == 0.0) return 1.0;
  vec3 sun = sun_direction.xyz;
  float climb = dot(place, sun);
  float reach = (1.0 + clouds_height) * (1.0 + clouds_height) - dot(place, place);
  float way = reach / (max(climb, 0.0) + sqrt(max(climb * climb + reach, 1.0e-8)));
  float under = step(0.0, reach);
  return 1.0 - 0.85 * under * clouds_shadow * clouds_density * cloud_over(normalize(place + way * sun));
}

// The light that reaches a place.
struct LightAt {
  vec3 up;   // unit, from the planet's centre to the place
  vec3 sun;  // sunlight before any cosine
  vec3 air;  // what the air around the place sends on
};

// height: over the sphere, planet radii.
LightAt light_at(vec3 up, float height) {
  LightAt at;
  at.up = up;
  // Reddened where the sun stands low, gone in the planet's own shadow.
  float climb = dot(up, sun_direction.xyz);
  float dip = sqrt(2.0 * max(height, 0.0));
  float risen = smoothstep(-0.02 - dip, 0.10, climb);
  float low = 1.0 - smoothstep(0.0, 0.30, climb);
  vec3 reddened = mix(vec3(1.0), air_dusk_color.rgb * 1.1, 0.62 * ripple.z * air_density * low * low);
  at.sun = sun_light.rgb * reddened * risen;
  at.air = sun_light.rgb * ripple.z * air_light(up, sun_direction.xyz, scene_air());
  return at;
}

// Light from the sky and from all around on a surface that faces along normal.
vec3 skylight(LightAt at, vec3 normal) {
  float open = 0.5 + 0.5 * dot(normal, at.up);
  return at.air * (0.22 * air_density * open) + sun_light.rgb * sun_ambient * vec3(0.32, 0.40, 0.62);
}

// Light of the sky itself where one looks along a ray from the place.
vec3 sky_along(LightAt at, vec3 ray) {
  float level = 1.0 - max(dot(at.up, ray), 0.0);
  float seen = air_density * mix(0.22, 1.0, level * level * level);
  return seen * (0.55 * at.air + wide_glow(dot(ray, sun_direction.xyz)) * sky_glow.rgb);
}

// The light of a surface as it arrives at the eye through the air before it. offset: from the eye to the surface.
vec3 through_air(vec3 light, LightAt at, vec3 offset) {
  Air air = scene_air();
  float distance_to = length(offset);
  vec3 ray = offset / distance_to;
  AirPath path = air_path(eye_position(), ray, air.top);
  float before = clamp(distance_to - path.enter, 0.0, path.leave - path.enter);
  float opacity = air_opacity_before(air_opacity(path.cosine, air), path.cosine, before, air.top);
  return mix(light, 0.55 * at.air + wide_glow(dot(ray, sun_direction.xyz)) * sky_glow.rgb, ripple.z * opacity);
}
