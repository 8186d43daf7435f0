// The surface of the water for an eye that passes through it.
#include "cloudy_sky.glsl"
#include "eye_in_water.glsl"

// Light of the surface as it comes to an eye under it.
vec3 light_of_surface_below(Water w, LightAt at, vec3 ray, float shade, SceneLight scene) {
  w.facing = reflect(w.facing, w.normal);
  vec3 mirrored = light_from_below(w, at, reflect(ray, w.facing), shade, scene);
  vec3 above = sky_from(at, ray_above(ray, w.facing, water_look()), scene);
  vec3 light = water_light_below(w, at, ray, above, mirrored, shade, water_look(), scene);
  return to_eye_in_water(light, surface_from_eye, scene);
}

vec3 surface_to_eye(Water w, LightAt at, vec3 ray, float shade, SceneLight scene) {
  return begins_in_water(ray) ? light_of_surface_below(w, at, ray, shade, scene) : light_of_surface(w, at, ray, shade, scene);
}
