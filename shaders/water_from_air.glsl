// The surface of the water for an eye that is never under it.

// What stands over the water along a ray that its surface throws back up. unseen_rough: fourth power of the roughness that stands
// for what is too small to be seen of its slopes.
vec3 seen_in_mirror(LightAt at, vec3 ray, float unseen_rough, SceneLight scene);

bool begins_in_water(vec3 ray) { return false; }

float pow4(float x) { return x * x * x * x; }

vec3 surface_to_eye(Water w, LightAt at, vec3 ray, float shade, SceneLight scene) {
  vec3 below = light_from_below(w, at, refracted_ray(ray, w.facing, water_look()), shade, scene);
  vec3 mirrored = seen_in_mirror(at, reflect(ray, w.facing), max(pow4(w.roughness) - pow4(water_roughness), 0.0), scene);
  vec3 light = water_light(w, at, ray, below, mirrored, shade, water_look(), scene);
  return through_air(light, at, surface_from_eye, scene);
}
