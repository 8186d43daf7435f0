// A calm sea, with or without ripples.
#include "water_surface.glsl"

// Where the water is, from the planet's centre; unit.
vec3 water_direction() { return normalize(eye_position() + surface_from_eye); }

vec3 water_place() { return surface_from_eye; }

vec3 gathered_on_bottom(vec3 sunlight, vec3 to_bottom, float depth, float footprint, LightAt at, SceneLight scene) { return vec3(0.0); }

// crust: 0..1, how far a crust covers the water.
void emit_calm_water(Ripples r, float crust, vec3 up) {
  r.rough += ripple.z;
  Water water = calm_water(up, depth_below(up), r, crust, water_look());
  water.foam = max(water.foam, water_foam * slopes.z);
  vec3 to_eye = -normalize(surface_from_eye);
  if (begins_in_water(surface_from_eye)) to_eye = reflect(to_eye, water.normal);
  emit_water(with_unseen_waves(water, ripple.z, to_eye), up, 0.0);
}
