// Clouds as flow noise on a sphere (Sandahl 2022, equation 18).
#include "lib/noise.glsl"

// Where a layer is asked for its noise, in its cells: the gradients of those before it (warp) stir it.
vec3 flow_place(vec3 direction, float frequency, float strength, vec3 warp, int layer, uint seed) {
  return direction * frequency + strength * warp + layer_offset(layer, seed);
}

// One layer at its place: returns its share and adds its gradient to the warp that stirs the next ones. turn: cosine and
// sine of the angle by which its gradients are turned.
float flow_layer(vec3 place, float amplitude, vec2 turn, int layer, uint seed, inout vec3 warp) {
  Noise n = turned_noise(ivec3(0), place, turn, layer_seed(layer, seed));
  warp += amplitude * n.gradient;
  return amplitude * n.value;
}

// The noise as a map without signs holds it, 0..1, and back. Noise passes its ends by a hundredth.
float noise_to_map(float noise) {
  return 0.5 + noise * (0.5 / 1.02);
}

float noise_from_map(float held) {
  return (held - 0.5) * (1.02 / 0.5);
}

// Thickness of the cloud, 0..1, from the noise at a place (its sum divided by the sum of amplitudes, -1..1). coverage:
// part of the sky that is covered, 0..1; softness 0..1.
float cloud_thickness(float noise, float coverage, float softness) {
  float threshold = 0.45 * (1.0 - 2.0 * coverage) - 0.12 * softness;
  float width = 0.03 + 0.55 * softness;
  float rise = clamp((noise - threshold) / width, 0.0, 1.0);
  return coverage <= 0.0 ? 0.0 : rise * rise * (3.0 - 2.0 * rise);
}
