// The surface of the water for an eye that passes through it.
#include "cloudy_sky.glsl"
#include "eye_in_water.glsl"
#include "land_in_mirror.glsl"

// What costs the most is found once, for whichever side is seen: both would be computed where there is no graphics card.
vec3 surface_to_eye(Water w, LightAt at, vec3 ray, float shade, SceneLight scene) {
  bool below = begins_in_water(ray);
  if (below) w.facing = reflect(w.facing, w.normal);
  vec3 mirrored = reflect(ray, w.facing);
  vec3 in_water = below ? mirrored : refracted_ray(ray, w.facing, water_look());
  vec3 in_air = below ? ray_above(ray, w.facing, water_look()) : mirrored;
  vec3 from_water = light_from_below(w, at, in_water, shade, scene);
  vec3 from_air = behind_land(sky_from(at, in_air, scene), !below, at, in_air, unseen_rough(w, water_look()), scene);
  if (below) return to_eye_in_water(water_light_below(w, at, ray, from_air, from_water, shade, water_look(), scene), surface_from_eye, scene);
  return through_air(water_light(w, at, ray, from_water, from_air, shade, water_look(), scene), at, surface_from_eye, scene);
}
