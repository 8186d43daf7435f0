// The ground for an eye of which the lens, or a part of it, is under water.
#include "eye_in_water.glsl"

// How much more sunlight reaches the ground through water than if that lay still, as a part of that. offset: of the place from the
// eye; up: unit.
float gathered_in_water(vec3 offset, float depth, vec3 up, SceneLight scene);

vec3 ground_to_eye(vec3 albedo, vec3 normal, float depth, vec3 offset, LightAt at, float shade, SceneLight scene) {
  vec3 light = ground_light(albedo, normal, at, shade, scene);
  if (!begins_in_water(offset)) return ground_through_air(light, depth, offset, at, scene);
  light += gathered_in_water(offset, depth, at.up, scene) * ground_sunlight(albedo, normal, at, shade, scene);
  return to_eye_in_water(light * left_at_depth(depth, at, water_look(), scene), offset, scene);
}
