// A calm sea, with or without ripples.
#include "water_light.glsl"

in vec3 surface_from_eye;

// Where the water is, from the planet's centre; unit.
vec3 water_direction() { return normalize(eye_position() + surface_from_eye); }

// Small waves at a place.
struct Ripples {
  vec3 gradient;
  float rough;  // fourth power of the roughness that stands for what is too small to be seen
  float wash;   // -1..1: where foam runs further up
};

// The steepness of a layer of ripples, as a part of the steepness of all.
float ripple_strength(int layer) { return layer == 0 ? 0.11 : 0.077; }

// The roughness (fourth power) that stands for a layer of which a part is not shown. shown: 0..1.
float unseen_roughness(int layer, float shown) {
  float strength = ripple_strength(layer) * water_ripples;
  return 3.0 * (1.0 - shown * shown) * strength * strength;
}

void emit_calm_water(Ripples r, vec3 up) {
  float own = water_roughness * water_roughness;
  float line = water_clarity * 0.30;
  Water w;
  w.normal = surface_normal(up, 1.0, r.gradient);
  w.depth = -textureLod(ground_map, up, levels.z).w;
  w.roughness = clamp(sqrt(sqrt(own * own + r.rough)), 0.02, 1.0);
  w.foam = water_foam * (1.0 - smoothstep(0.2, 1.0, w.depth / max(line, 1.0e-9) + 0.5 * r.wash));
  LightAt at = light_at(up, 0.0);
  vec3 light = water_light(w, at, normalize(surface_from_eye), cloud_shade(up * sea.x));
  emit_surface(through_air(light, at, surface_from_eye), surface_from_eye, w.normal, sea.x - 1.0);
}
