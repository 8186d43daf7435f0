// The surface of the ground where a mesh carries it: what its ways of finding normals have in common.
#include "ground_map.glsl"
#include "output.glsl"

in vec3 surface_from_eye;

// The ground's light as it comes to the eye. depth: of the ground under the still water, radii; offset: of the place from the eye.
vec3 ground_to_eye(vec3 albedo, vec3 normal, float depth, vec3 offset, LightAt at, float shade, SceneLight scene);

// Light of the ground through the air. Just under water it has come through some of that; further down the water hides the ground.
vec3 ground_through_air(vec3 light, float depth, vec3 offset, LightAt at, SceneLight scene) {
  vec3 through_water = light * transmitted(water_extinction.rgb, 2.0 * depth);
  // Between water and what stands in its mirror the air is the water's to tell.
  return mirror.w > 0.0 ? through_water : through_air(through_water, at, offset, scene);
}

vec3 surface_position() { return eye_position() + surface_from_eye; }

// offset: of the place from the eye; ground: there, its gradient as fine as the pixels; rise: as mean_normal takes it; grain: of its colour, about -1..1.
void emit_ground(vec3 offset, GroundAt ground, float rise, float grain) {
  vec3 place = eye_position() + offset;
  float radius = length(place);
  vec3 up = place / radius;
  vec3 normal = mean_normal(up, radius, ground, rise, -ray_to(offset));
  vec3 albedo = grained(ground_albedo(up, ground, normal, scene_bands()), grain);
  albedo = wetted(albedo, wet_part(ground.height, water_extinction.w), water_refraction_index);
  SceneLight scene = scene_light();
  LightAt at = light_at(up, radius - 1.0, scene);
  vec3 light = ground_to_eye(albedo, normal, -ground_map_scale.w * ground.height, offset, at, shade_of_clouds(place), scene);
  emit_surface(light, offset, normalize(normal), radius - 1.0);
}
