// The surface of the water for an eye that is never under it.
bool begins_in_water(vec3 ray) { return false; }

vec3 surface_to_eye(Water w, LightAt at, vec3 ray, float shade, SceneLight scene) {
  return light_of_surface(w, at, ray, shade, scene);
}
