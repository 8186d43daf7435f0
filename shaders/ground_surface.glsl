// The surface of the ground where a mesh carries it: what its ways of finding normals have in common.
#include "ground_map.glsl"
#include "water_look.glsl"
#include "output.glsl"

in vec3 surface_from_eye;

// How much more sunlight reaches the ground through water than if that lay still, as a part of that. offset: of the place from the
// eye; up: unit.
float gathered_in_water(vec3 offset, float depth, vec3 up, SceneLight scene);

vec3 surface_position() { return eye_position() + surface_from_eye; }

// offset: of the place from the eye; ground: there, its gradient as fine as the pixels; rise: as mean_normal takes it; grain: of its colour, about -1..1.
void emit_ground(vec3 offset, GroundAt ground, float rise, float grain) {
  vec3 place = eye_position() + offset;
  float radius = length(place);
  vec3 up = place / radius;
  vec3 normal = mean_normal(up, radius, ground, rise, -normalize(offset));
  vec3 albedo = grained(ground_albedo(up, ground, normal, scene_bands()), grain);
  albedo = wetted(albedo, wet_part(ground.height, water_extinction.w), water_refraction_index);
  SceneLight scene = scene_light();
  LightAt at = light_at(up, radius - 1.0, scene);
  float shade = shade_of_clouds(place);
  vec3 light = ground_light(albedo, normal, at, shade, scene);
  float depth = -ground_map_scale.w * ground.height;
  if (begins_in_water(offset)) {
    light += gathered_in_water(offset, depth, up, scene) * ground_sunlight(albedo, normal, at, shade, scene);
    light = to_eye_in_water(light * left_at_depth(depth, at, water_look(), scene), offset, scene);
  } else {
    // Just under water the light has come through some of it; further down the water hides the ground.
    light = through_air(light * transmitted(water_extinction.rgb, 2.0 * depth), at, offset, scene);
  }
  emit_surface(light, offset, normalize(normal), radius - 1.0);
}
