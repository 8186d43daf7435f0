// Water that mirrors land before a sky with its clouds.
#include "cloudy_sky.glsl"

uniform sampler2D mirrored_land;    // its light, weighted by what it covers, before the air and as exposed; w: how much that is
uniform sampler2D mirrored_depths;

// Where the still water shows a place (from the eye) in its mirror.
vec2 place_in_mirror(vec3 offset) {
  vec4 clip = mirror_from_eye * vec4(offset, 1.0);
  return 0.5 + 0.5 * clip.xy / max(clip.w, 1.0e-9);
}

// How far the land is, from an eye as far below the water as the true one is above, along a ray (unit) of that which meets the
// place of the mirror; about as far as the sky where there is none.
float way_in_mirror(vec2 place, vec3 ray) {
  vec3 plumb = normalize(eye_high.xyz);
  float climb = (1.0 - textureLod(mirrored_depths, place, 0.0).x) / mirror.z - foot_in_mirror();
  // Land is so much steeper above the water than above that eye as its height over that tells from so far away; the sphere falls off.
  float steeper = dot(plumb, ray) - climb * (mirror_from_eye * vec4(ray, 0.0)).w;
  return 2.0 * mirror.x / max(steeper + sqrt(steeper * steeper + 2.0 * mirror.x / sea.x), 1.0e-9);
}

// How far the land is that stands in the mirror at a place (from the eye), from the place of the water.
float way_to_land(vec3 place) {
  vec3 mirrored_eye = -2.0 * mirror.x * normalize(eye_high.xyz);
  vec3 ray = normalize(place - mirrored_eye);
  return distance(mirrored_eye + way_in_mirror(place_in_mirror(place), ray) * ray, surface_from_eye);
}

// The land along rays (unit) around one, as slopes that are not shown throw them up and down; they hardly do aside, where one looks
// along the water. As mirrored_land, but through the air.
vec4 mean_land(LightAt at, vec3 ray, float unseen_rough, SceneLight scene) {
  const float seen_spread = 0.93;  // of slopes that face the eye (Rayleigh), doubled by the mirror
  float spread = seen_spread * sqrt(unseen_rough);
  float level = log2(max(0.8 * spread / mirror.y, 1.0));
  vec3 climb = spread * (at.up - dot(at.up, ray) * ray);
  // Here, and further on, where lower land stands.
  vec3 on = length(surface_from_eye) * normalize(ray - dot(at.up, ray) * at.up);
  float way = min(way_to_land(surface_from_eye), min(way_to_land(surface_from_eye + on), way_to_land(surface_from_eye + 4.0 * on)));
  vec4 mean = vec4(0.0);
  int samples = int(slopes.w);
  for (int i = 0; i < samples; ++i) {
    // Quarters of a normal distribution.
    float deviations = samples == 1 ? 0.0 : i == 0 ? -1.15 : i == 1 ? -0.32 : i == 2 ? 0.32 : 1.15;
    vec3 thrown = normalize(ray + deviations * climb);
    mean += textureLod(mirrored_land, place_in_mirror(surface_from_eye + way * thrown), level);
  }
  mean /= float(samples) * vec4(vec3(sun_direction.w), 1.0);
  vec3 light = through_air(mean.rgb / max(mean.a, 1.0e-3), at, way * ray, scene);
  return vec4(mean.a * light, mean.a);
}

vec3 seen_in_mirror(LightAt at, vec3 ray, float unseen_rough, SceneLight scene) {
  vec3 light = sky_from(at, ray, scene);
  for (int turn = 0; turn < (mirror.x > 0.0 ? 1 : 0); ++turn) {
    scene.eye = sea.x * at.up;
    scene.eye_height = sea.x - 1.0;
    vec4 land = mean_land(at, ray, unseen_rough, scene);
    light = land.rgb + (1.0 - land.a) * light;
  }
  return light;
}
