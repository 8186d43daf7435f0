// The surface of the water for an eye that is never under it.

// What stands over the water along a ray that its surface throws back up. rough: its unseen_rough.
vec3 seen_in_mirror(LightAt at, vec3 ray, float rough, SceneLight scene);

bool begins_in_water(vec3 ray) { return false; }

vec3 surface_to_eye(Water w, LightAt at, vec3 ray, float shade, SceneLight scene) {
  vec3 below = light_from_below(w, at, refracted_ray(ray, w.facing, water_look()), shade, scene);
  vec3 mirrored = seen_in_mirror(at, reflect(ray, w.facing), unseen_rough(w, water_look()), scene);
  vec3 light = water_light(w, at, ray, below, mirrored, shade, water_look(), scene);
  return through_air(light, at, surface_from_eye, scene);
}
