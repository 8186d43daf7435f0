// The ground for an eye that is never under water.
vec3 ground_to_eye(vec3 albedo, vec3 normal, float depth, vec3 offset, LightAt at, float shade, SceneLight scene) {
  return ground_through_air(ground_light(albedo, normal, at, shade, scene), depth, offset, at, scene);
}
