// The surface of the ground where a mesh carries it: what its ways of finding normals have in common.
#include "ground_light.glsl"
#include "output.glsl"

in vec3 surface_from_eye;

vec3 surface_position() { return eye_position() + surface_from_eye; }

// ground: at the place, its gradient as fine as the pixels; grain: of its colour, about -1..1.
void emit_ground(GroundAt ground, float grain) {
  vec3 place = surface_position();
  float radius = length(place);
  vec3 up = place / radius;
  vec3 normal = slope_normal(up, radius, ground.gradient);
  vec3 albedo = ground_albedo(up, ground, normal) * (1.0 + 0.35 * grain);
  // Just under water the light has come through some of it; further down the water hides the ground.
  albedo *= transmitted(water_extinction.rgb, -2.0 * ground_map_scale.w * ground.height);
  LightAt at = light_at(up, radius - 1.0);
  vec3 light = through_air(ground_light(albedo, normal, at, cloud_shade(place)), at, surface_from_eye);
  emit_surface(light, surface_from_eye, normal, radius - 1.0);
}
