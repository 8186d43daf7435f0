// How the scene's light, air and clouds act on any surface: the formulas of lib fed with the scene's parameters.
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

// The noise that clouds are made from, at the frame's time. blur: levels of the map to leave out.
float cloud_noise(vec3 direction, float blur) {
  vec3 d = vec3(cloud_turn.x * direction.x + cloud_turn.y * direction.y,
                cloud_turn.x * direction.y - cloud_turn.y * direction.x, direction.z);
  return dot(texture(clouds_map, d, blur).rgb, cloud_moments.xyz);
}

// Thickness of the clouds over a place, 0..1.
float cloud_over(vec3 direction, float blur) {
  return cloud_thickness(cloud_noise(direction, blur), clouds_coverage, clouds_softness);
}

// Part of the sunlight that the clouds leave at a place under them.
float cloud_shade(vec3 place) {
  if (cloud_turn.w == 0.0 || clouds_shadow == 0.0) return 1.0;
  vec3 sun = sun_direction.xyz;
  float climb = dot(place, sun);
  float reach = (1.0 + clouds_height) * (1.0 + clouds_height) - dot(place, place);
  float way = reach / (max(climb, 0.0) + sqrt(max(climb * climb + reach, 1.0e-8)));
  return 1.0 - 0.85 * clouds_shadow * clouds_density * cloud_over(normalize(place + way * sun), 1.0);
}

// Sunlight on a place before any cosine: reddened where the sun stands low, gone in the planet's own shadow.
vec3 sunlight_at(vec3 up, float height) {
  float climb = dot(up, sun_direction.xyz);
  float dip = sqrt(2.0 * max(height, 0.0));
  float risen = smoothstep(-0.02 - dip, 0.10, climb);
  float low = 1.0 - smoothstep(0.0, 0.30, climb);
  vec3 reddened = mix(vec3(1.0), air_dusk_color.rgb * 1.1, 0.62 * ripple.z * air_density * low * low);
  return sun_light.rgb * reddened * risen;
}

// Light from the sky and from all around on a surface that faces along normal.
vec3 skylight_at(vec3 up, vec3 normal) {
  float open = 0.5 + 0.5 * dot(normal, up);
  vec3 sky = ripple.z > 0.0 ? air_light(up, sun_direction.xyz, scene_air()) * 0.22 * air_density : vec3(0.0);
  return sun_light.rgb * (sky * open + sun_ambient * vec3(0.32, 0.40, 0.62));
}

// Light of the sky itself where one looks along a ray from a place on the planet.
vec3 sky_along(vec3 up, vec3 ray) {
  if (ripple.z == 0.0) return vec3(0.0);
  Air air = scene_air();
  float cosine = max(dot(up, ray), 0.0);
  float level = 1.0 - cosine;
  float opacity = air.density * mix(0.22, 1.0, level * level * level);
  return sun_light.rgb * 0.55 * opacity * air_light(up, sun_direction.xyz, air);
}

// The light of a surface as it arrives at the eye through the air before it. offset: from the eye to the surface.
vec3 through_air(vec3 light, vec3 offset) {
  if (ripple.z == 0.0) return light;
  Air air = scene_air();
  float distance_to = length(offset);
  vec3 ray = offset / distance_to;
  vec3 eye = eye_position();
  AirPath path = air_path(eye, ray, air.top);
  float before = clamp(distance_to - path.enter, 0.0, path.leave - path.enter);
  float opacity = air_opacity_before(air_opacity(path.cosine, air), path.cosine, before, air.top);
  vec3 up = normalize(eye + offset);
  return mix(light, sun_light.rgb * 0.55 * air_light(up, sun_direction.xyz, air), opacity);
}
