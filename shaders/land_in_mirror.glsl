// Land in the mirror of the water. Its picture is that of an eye as far below the still water as the true one is above
// (src/planet/mirror.hpp).

uniform sampler2D mirrored_land;    // its light as exposed, before the air, weighted by what it covers; w: how much that is
uniform sampler2D mirrored_depths;  // 1 less mirror.z times how steeply that eye looks up to land over the water

// Where in that picture a place (from the true eye) is.
vec2 place_in_mirror(vec3 offset) {
  vec4 clip = mirror_from_eye * vec4(offset, 1.0);
  return 0.5 + 0.5 * clip.xy / max(clip.w, 1.0e-9);
}

// How far the land that stands there at a place (from the true eye) is from the pixel; very far if there is none.
float way_to_land(vec3 place) {
  vec3 plumb = normalize(eye_high.xyz);
  vec3 ray = normalize(from_mirrored_eye(place));
  float rise = (1.0 - textureLod(mirrored_depths, place_in_mirror(place), 0.0).x) / mirror.z - foot_in_mirror();
  float way = way_in_mirror(sea.x, mirror.x, dot(plumb, ray), rise * (mirror_from_eye * vec4(ray, 0.0)).w);
  return distance(way * ray, from_mirrored_eye(surface_from_eye));
}

// About how far land is along a ray: what the still water mirrors here, or further on, where lower land stands.
float way_to_lowest_land(vec3 ray, vec3 up) {
  vec3 level = ray - dot(up, ray) * up;
  vec3 on = length(surface_from_eye) / max(length(level), 1.0e-3) * level;
  return min(way_to_land(surface_from_eye), min(way_to_land(surface_from_eye + on), way_to_land(surface_from_eye + 4.0 * on)));
}

// Whether any land stands so low in the mirror, if rays around one (unit) are thrown up and down.
bool may_meet_land(vec3 ray, float spread, vec3 up) {
  const float widest = 2.0;  // of the deviations of rays, and of what blurs them
  float here = dot(normalize(from_mirrored_eye(surface_from_eye)), normalize(eye_high.xyz));
  return mirror.x > 0.0 && min(here, dot(ray, up) - widest * spread) < depth.w;
}

// The land along those rays, as slopes that are not shown throw them; aside they hardly do, where one looks along the water. As
// mirrored_land, but through the air. scene: for an eye at the pixel.
vec4 mean_land(LightAt at, vec3 ray, float spread, SceneLight scene) {
  float level = level_of_spread(spread, mirror.y);
  float way = way_to_lowest_land(ray, at.up);
  vec4 mean = vec4(0.0);
  int rays = int(slopes.w);
  for (int i = 0; i < rays; ++i) {
    float thrown = rays == 1 ? 0.0 : spread * deviation_of_quarter(i);
    vec3 along = normalize(ray + thrown * (at.up - dot(at.up, ray) * ray));
    mean += textureLod(mirrored_land, place_in_mirror(surface_from_eye + way * along), level);
  }
  mean /= float(rays) * vec4(vec3(sun_direction.w), 1.0);
  vec3 light = through_air(mean.rgb / max(mean.a, 1.0e-3), at, max(way, 1.0e-9) * ray, scene);
  return vec4(mean.a * light, mean.a);
}

// A light from the sky with the land before it, as the water mirrors both along a ray (unit). rough: unseen_rough of the water; mirrors:
// whether it does. A loop without a turn costs nothing; what a condition leaves out is computed where there is no graphics card.
vec3 behind_land(vec3 light, bool mirrors, LightAt at, vec3 ray, float rough, SceneLight scene) {
  float spread = thrown_spread(rough);
  int turns = mirrors && may_meet_land(ray, spread, at.up) ? 1 : 0;
  for (int turn = 0; turn < turns; ++turn) {
    scene.eye = sea.x * at.up;
    scene.eye_height = sea.x - 1.0;
    vec4 land = ray_up.w * mean_land(at, ray, spread, scene);
    light = land.rgb + (1.0 - land.a) * light;
  }
  return light;
}
