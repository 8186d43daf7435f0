// The sky as water mirrors it.
#include "cloud_map.glsl"

// The sky with its clouds along a ray (unit) from a place of the water. Without clouds the loop has no turn: what a condition leaves
// out is computed all the same where there is no graphics card.
vec3 sky_from(LightAt at, vec3 ray, SceneLight scene) {
  vec3 light = sky_along(at, ray, scene);
  vec3 place = sea.x * at.up;
  scene.eye = place;
  scene.eye_height = sea.x - 1.0;
  for (int turn = 0; turn < int(cloud_turn.w); ++turn) {
    Clouds clouds = scene_clouds();
    float way = way_to_clouds(place, ray, clouds);
    CloudAt cloud = cloud_place(normalize(place + way * ray), scene.sun, clouds);
    cloud.noise = cloud_noise(cloud.up);
    cloud.rise = cloud_noise(cloud_entry(cloud)) - cloud.noise;
    Veil veil = cloud_veil(cloud, way * ray, clouds, scene);
    light = way > 0.0 ? veil.light + (1.0 - veil.opacity) * light : light;
  }
  return light;
}
