// Octaves of flow noise whose gradient is exact (Sandahl 2022, equation 18), one at a time, and how their gradients bend.
#include "lib/noise.glsl"

// The second derivatives of what noise_corner adds, before its scale.
mat3 noise_corner_bend(vec3 offset, vec3 direction) {
  float reach = max(0.5 - dot(offset, offset), 0.0);
  float ramp = dot(direction, offset);
  mat3 mixed = outerProduct(direction, offset) + outerProduct(offset, direction);
  vec3 across = vec3(-6.0 * reach * reach * ramp);
  mat3 bend = mat3(vec3(across.x, 0.0, 0.0), vec3(0.0, across.y, 0.0), vec3(0.0, 0.0, across.z));
  return bend + (24.0 * reach * ramp) * outerProduct(offset, offset) - (6.0 * reach * reach) * mixed;
}

// The second derivatives of turned_noise: how its gradient changes, per cell along each axis.
mat3 turned_noise_bend(ivec3 cell, vec3 q, vec2 turn, uint seed) {
  Simplex s = simplex_of(cell, q);
  uint key = seed_key(seed);
  mat3 a = noise_corner_bend(s.offset0, turned_direction(hash_key(s.key0, key), turn));
  mat3 b = noise_corner_bend(s.offset1, turned_direction(hash_key(s.key1, key), turn));
  mat3 c = noise_corner_bend(s.offset2, turned_direction(hash_key(s.key2, key), turn));
  mat3 d = noise_corner_bend(s.offset3, turned_direction(hash_key(s.key3, key), turn));
  return noise_scale * ((a + b) + (c + d));
}

// What the octaves so far of flow noise (18) have in common.
struct Flow {
  vec3 warp;   // sum of the gradients, which stirs the next octave
  mat3 bend;   // how the warp changes with the place
  vec3 slope;  // gradient of the sum of octaves
};

Flow no_flow() {
  Flow f;
  f.warp = vec3(0.0);
  f.bend = mat3(0.0);
  f.slope = vec3(0.0);
  return f;
}

// One octave of flow noise: n is turned_noise, and bend its second derivatives, at frequency times the place and strength
// times the warp of those before. The gradient is exact: it knows that the place is stirred.
void add_flow_octave(inout Flow f, Noise n, mat3 bend, float amplitude, float frequency, float strength) {
  mat3 stirred = mat3(vec3(frequency, 0.0, 0.0), vec3(0.0, frequency, 0.0), vec3(0.0, 0.0, frequency)) + strength * f.bend;
  f.slope += amplitude * (transpose(stirred) * n.gradient);
  f.warp += amplitude * n.gradient;
  f.bend += amplitude * (bend * stirred);
}
