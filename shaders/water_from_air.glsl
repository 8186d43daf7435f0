// The surface of the water for an eye that is never under it.

// The sky along a ray that the surface throws back up.
vec3 mirrored_sky(LightAt at, vec3 ray, SceneLight scene);

bool begins_in_water(vec3 ray) { return false; }

vec3 surface_to_eye(Water w, LightAt at, vec3 ray, float shade, SceneLight scene) {
  vec3 below = light_from_below(w, at, refracted_ray(ray, w.facing, water_look()), shade, scene);
  vec3 mirrored = mirrored_sky(at, reflect(ray, w.facing), scene);
  vec3 light = water_light(w, at, ray, below, mirrored, shade, water_look(), scene);
  return through_air(light, at, surface_from_eye, scene);
}
