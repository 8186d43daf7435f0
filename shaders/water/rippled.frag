// A calm sea with ripples of flow noise (Sandahl 2022, equations 12 and 13).
#include "calm_water.glsl"
#include "lib/noise.glsl"

void add_ripples(inout Ripples r, int layer, vec3 up, float footprint) {
  float frequency = water_ripple_frequency * (layer == 0 ? 1.0 : 2.3);
  vec2 turn = layer == 0 ? ripple_turns.xy : ripple_turns.zw;
  uint seed = uint(planet_seed) + 71u;
  float shown = layer_weight(frequency, footprint);
  Noise n = turned_noise(ivec3(0), up * frequency + layer_offset(layer, seed), turn, layer_seed(layer, seed));
  r.gradient += shown * ripple_strength(layer) * ripple.x * n.gradient;
  r.wash += shown * n.value * 0.5;
  r.rough += unseen_roughness(layer, shown);
}

void main() {
  vec3 up = water_direction();
  float footprint = pixel_footprint(up, surface_from_eye, 0.12);
  Ripples r;
  r.gradient = vec3(0.0);
  r.rough = 0.0;
  r.wash = 0.0;
  for (int layer = 0; layer < 2; ++layer) add_ripples(r, layer, up, footprint);  // half the code to compile
  emit_calm_water(r, up);
}
