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
  float crust;  // 0..1: how far a crust covers the water
};

// The steepness of the first layer of ripples, as a part of the steepness of all, and of each other one as a part of that
// of the layer before it. As many layers as told_ripples are told in the roughness where they are too small to be seen.
const float first_ripple = 0.11;
const float next_ripple = 0.7;
const int told_ripples = 2;

// The roughness (fourth power) that stands for a layer of which a part is not shown. strength: as a part of all; shown: 0..1.
float unseen_roughness(float strength, float shown) {
  float steepness = strength * water_ripples;
  return 3.0 * (1.0 - shown * shown) * steepness * steepness;
}

void emit_calm_water(Ripples r, vec3 up) {
  float own = water_roughness * water_roughness;
  float line = water_clarity * 0.30;
  Water w;
  w.normal = surface_normal(up, 1.0, r.gradient);
  w.depth = -textureLod(ground_map, up, levels.z).w;
  w.roughness = clamp(sqrt(sqrt(own * own + r.rough)), 0.02, 1.0);
  w.foam = water_foam * (1.0 - smoothstep(0.2, 1.0, w.depth / max(line, 1.0e-9) + 0.5 * r.wash));
  w.foam = max(w.foam, r.crust);
  LightAt at = light_at(up, 0.0);
  vec3 light = water_light(w, at, normalize(surface_from_eye), cloud_shade(up * sea.x));
  emit_surface(through_air(light, at, surface_from_eye), surface_from_eye, w.normal, sea.x - 1.0);
}
