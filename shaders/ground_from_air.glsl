// The ground for an eye that is never under water. Just under it the light has come through some of it; further down the water hides
// the ground.
vec3 ground_to_eye(vec3 albedo, vec3 normal, float depth, vec3 offset, LightAt at, float shade, SceneLight scene) {
  vec3 light = ground_light(albedo * transmitted(water_extinction.rgb, 2.0 * depth), normal, at, shade, scene);
  return through_air(light, at, offset, scene);
}
