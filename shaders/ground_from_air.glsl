// The ground for an eye that is never under water.
vec3 ground_to_eye(vec3 albedo, vec3 normal, float depth, vec3 offset, LightAt at, float shade, SceneLight scene) {
  vec3 light = ground_light(albedo, normal, at, shade, scene);
  // Between water and what stands in its mirror the air is the water's to tell.
  return mirror.w > 0.0 ? light : ground_through_air(light, depth, offset, at, scene);
}
