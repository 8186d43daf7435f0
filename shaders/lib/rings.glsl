// Rings in the plane of a planet's equator.
#include "lib/light.glsl"
#include "lib/noise.glsl"

struct Rings {
  float inner, outer;  // radii
  float density;       // part of the light that the densest ringlets hold back, 0..1
  vec3 color;
  uint seed;
};

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
  OctaveSum sum = no_octaves();
  float frequency = 5.0;
  for (int i = 0; i < 6; ++i) {
    add_octave(sum, mix(0.5, line_noise(across * frequency, i, seed), layer_weight(frequency, footprint)), 0.72);
    frequency *= 2.3;
  }
  float rim = max(0.03, footprint);
  float edges = smoothstep(0.0, rim, across) * (1.0 - smoothstep(1.0 - rim, 1.0, across));
  return edges * smoothstep(0.30, 0.72, octave_mean(sum));
}

// Part of the light that is held back where it passes obliquely. matter: 0..1; density: part held back of light that
// passes straight through the densest ringlets, 0..1; cosine: between the light's way and the plane's normal, of any sign.
float ring_opacity(float matter, float density, float cosine) {
  return 1.0 - pow(max(1.0 - density * matter, 1.0e-4), 1.0 / max(abs(cosine), 0.08));
}

// Where a place of the plane lies: 0 at the inner edge, 1 at the outer one.
float across_rings(vec3 place, Rings rings) {
  return (length(place) - rings.inner) / max(rings.outer - rings.inner, 1.0e-6);
}

// Part of the sunlight that the rings leave at a place near the planet, 0..1. sun: unit; footprint: as above.
float ring_shade(vec3 place, vec3 sun, Rings rings, float footprint) {
  if (place.z * sun.z >= 0.0) return 1.0;  // the plane lies behind
  float across = across_rings(place - place.z / sun.z * sun, rings);
  if (across <= 0.0 || across >= 1.0) return 1.0;
  return 1.0 - ring_opacity(ring_matter(across, footprint, rings.seed), rings.density, sun.z);
}

// Part of the sunlight that a planet of radius 1 leaves at a place, with a soft edge. sun: unit.
float planet_shade(vec3 place, vec3 sun) {
  float along = dot(place, sun);
  float beside = length(place - along * sun);
  return along > 0.0 ? 1.0 : smoothstep(0.985, 1.015, beside);
}

// The rings along a ray that meets them at a place, lit by the sun from the side that is seen or through them from the
// other. ray: unit; footprint: as above.
Veil ring_veil(vec3 place, vec3 ray, Rings rings, float footprint, SceneLight scene) {
  float matter = ring_matter(across_rings(place, rings), footprint, rings.seed);
  // Many small bodies look as bright from all sides; through a thin part more light comes than through a dense one.
  float through = 0.5 * (1.0 - rings.density * matter);
  float brightness = ray.z * scene.sun.z < 0.0 ? 1.0 : through;
  float lit = planet_shade(place, scene.sun) * smoothstep(0.0, 0.02, abs(scene.sun.z));
  vec3 sunlight = scene.sunlight * (0.35 * brightness * lit + 0.02 * scene.ambient);
  Veil veil;
  veil.opacity = ring_opacity(matter, rings.density, ray.z);
  veil.light = rings.color * mix(0.7, 1.0, matter) * sunlight * veil.opacity;
  return veil;
}

// Their shadow as a veil before all that it falls on: of the light there is little beside the sun's. place: near the
// planet's surface. Returns its opacity.
float ring_shadow(vec3 place, Rings rings, SceneLight scene) {
  float by_day = smoothstep(0.0, 0.15, dot(normalize(place), scene.sun));
  return 0.85 * (1.0 - ring_shade(place, scene.sun, rings, ring_shadow_blur)) * by_day;
}
