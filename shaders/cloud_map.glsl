// The clouds of the scene, whose noise a map holds.
#include "light_block.glsl"
#include "lib/cloud_light.glsl"

// The noise that clouds are made from, at three moments; cloud_moments weights them.
uniform samplerCube clouds_map;

Clouds scene_clouds() {
  Clouds c;
  c.height = clouds_height;
  c.thickness = clouds_thickness;
  c.coverage = clouds_coverage;
  c.softness = clouds_softness;
  c.density = clouds_density;
  c.shadow = clouds_shadow;
  c.color = clouds_color.rgb;
  return c;
}

// The noise that clouds are made from, at the frame's time.
float cloud_noise(vec3 direction) {
  // Texels of 10 bits are cheaper to fetch than floats where there is no graphics card.
  return noise_from_map(dot(textureLod(clouds_map, drifted(direction, cloud_turn.xy), cloud_turn.z).rgb, cloud_moments.xyz));
}

// Part of the sunlight that the clouds leave at a place.
float shade_of_clouds(vec3 place) {
  if (cloud_turn.w == 0.0 || clouds_shadow == 0.0) return 1.0;
  Clouds clouds = scene_clouds();
  float noise = cloud_noise(cloud_before_sun(place, sun_direction.xyz, clouds));
  return cloud_shade(place, cloud_thickness(noise, clouds_coverage, clouds_softness), clouds);
}

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
