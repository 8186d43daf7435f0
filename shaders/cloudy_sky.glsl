// The sky as water mirrors it.
#include "cloud_map.glsl"

// The sky with its clouds along a ray (unit) from a place of the water.
vec3 sky_from(LightAt at, vec3 ray, SceneLight scene) {
  vec3 light = sky_along(at, ray, scene);
  Clouds clouds = scene_clouds();
  vec3 place = sea.x * at.up;
  float way = way_to_clouds(place, ray, clouds);
  if (cloud_turn.w == 0.0 || way <= 0.0) return light;
  CloudAt cloud = cloud_place(normalize(place + way * ray), scene.sun, clouds);
  cloud.noise = cloud_noise(cloud.up);
  cloud.rise = cloud_noise(cloud_entry(cloud)) - cloud.noise;
  scene.eye = place;
  scene.eye_height = sea.x - 1.0;
  Veil veil = cloud_veil(cloud, way * ray, clouds, scene);
  return veil.light + (1.0 - veil.opacity) * light;
}
