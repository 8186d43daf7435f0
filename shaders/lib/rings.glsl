// Rings in the plane of a planet's equator.
#include "lib/noise.glsl"

// Footprint with which their shadow is read: its edges are soft, for the sun is no point.
const float ring_shadow_blur = 0.02;

// Noise along a line, 0..1: a value in each whole number, smoothly joined. layer, seed: which line.
float line_noise(float x, int layer, uint seed) {
  float cell = floor(x);
  float t = x - cell;
  float from = hash_parts(hash_cell(ivec3(int(cell), layer, 41), seed)).x / 1023.0;
  float to = hash_parts(hash_cell(ivec3(int(cell) + 1, layer, 41), seed)).x / 1023.0;
  return mix(from, to, t * t * (3.0 - 2.0 * t));
}

// How many ringlets lie at a place, as a part of the most, 0..1. across: 0 at the inner edge, 1 at the outer one; nothing
// lies beyond. footprint: distance of neighbouring samples in the same measure, > 0; ringlets that they can't show are
// left out.
float ring_matter(float across, float footprint, uint seed) {
  float amplitude = 1.0;
  float frequency = 5.0;
  float total = 0.0;
  float sum = 0.0;
  for (int i = 0; i < 6; ++i) {
    sum += amplitude * mix(0.5, line_noise(across * frequency, i, seed), layer_weight(frequency, footprint));
    total += amplitude;
    amplitude *= 0.72;
    frequency *= 2.3;
  }
  float rim = max(0.03, footprint);
  float edges = smoothstep(0.0, rim, across) * (1.0 - smoothstep(1.0 - rim, 1.0, across));
  return edges * smoothstep(0.30, 0.72, sum / total);
}

// Part of the light that is held back where it passes obliquely. matter: 0..1; density: part held back of light that
// passes straight through the densest ringlets, 0..1; cosine: between the light's way and the plane's normal, of any sign.
float ring_opacity(float matter, float density, float cosine) {
  return 1.0 - pow(max(1.0 - density * matter, 1.0e-4), 1.0 / max(abs(cosine), 0.08));
}

// Part of the sunlight that the rings leave at a place near the planet, 0..1. sun: unit; inner, outer: radii of the rings;
// footprint: as above.
float ring_shade(vec3 place, vec3 sun, float inner, float outer, float density, float footprint, uint seed) {
  if (place.z * sun.z >= 0.0) return 1.0;  // the plane lies behind
  vec3 crossing = place - place.z / sun.z * sun;
  float across = (length(crossing) - inner) / max(outer - inner, 1.0e-6);
  if (across <= 0.0 || across >= 1.0) return 1.0;
  return 1.0 - ring_opacity(ring_matter(across, footprint, seed), density, sun.z);
}

// Part of the sunlight that a planet of radius 1 leaves at a place, with a soft edge. sun: unit.
float planet_shade(vec3 place, vec3 sun) {
  float along = dot(place, sun);
  float beside = length(place - along * sun);
  return along > 0.0 ? 1.0 : smoothstep(0.985, 1.015, beside);
}
