// Simplex noise in three dimensions whose gradients can be turned (Gustavson & McEwan, "Tiling simplex noise and flow
// noise in two and three dimensions"; Sandahl 2022, sections 2.1 to 2.3).
//
// A place is given as a cell of the skewed lattice (integers) and a position q relative to that cell's corner, in cells.
// noise(cell, q) is the same field whichever cell it is told from, so a caller far from the origin chooses a cell close
// by and keeps its precision. The lattice repeats only where 32-bit integers do.
#include "lib/tangent.glsl"

struct Noise {
  float value;    // about -1 to 1; |value| can pass 1 by a hundredth
  vec3 gradient;  // of value by position, per cell
};

Noise no_noise() {
  Noise n;
  n.value = 0.0;
  n.gradient = vec3(0.0);
  return n;
}

// The lattice's axes as they enter the hash; a neighbour's key is its cell's plus these.
const uvec3 cell_step = uvec3(0x8da6b343u, 0xd8163841u, 0xcb1ab31fu);

uvec3 cell_key(ivec3 cell) {
  return uvec3(cell) * cell_step;
}

// What a seed adds to every hash.
uint seed_key(uint seed) {
  return seed * 0x9e3779b9u;
}

// A well mixed integer from the keys of a cell and of a seed.
uint hash_key(uvec3 cell, uint seed) {
  uint h = cell.x ^ cell.y ^ cell.z ^ seed;
  h ^= h >> 16;
  h *= 0x7feb352du;
  h ^= h >> 15;
  h *= 0x846ca68bu;
  return h ^ (h >> 16);
}

// A well mixed integer from a cell and a seed: the same on every machine.
uint hash_cell(ivec3 cell, uint seed) {
  return hash_key(cell_key(cell), seed_key(seed));
}

// A vector from 32 random bits, spread over an octahedron: no direction of the lattice is preferred. Its length is at
// least 0.57 and at most 1.
vec3 hash_octahedron(uint h) {
  float x = float(int(h & 0xffffu)) * (1.0 / 32767.5) - 1.0;
  float y = float(int(h >> 16)) * (1.0 / 32767.5) - 1.0;
  float z = 1.0 - abs(x) - abs(y);
  float fold = max(-z, 0.0);
  // No fold is longer than x or y: both move towards 0 by fold.
  return vec3(x - clamp(x, -fold, fold), y - clamp(y, -fold, fold), z);
}

// The same as a unit vector.
vec3 hash_direction(uint h) {
  return normalize(hash_octahedron(h));
}

// What one corner of a simplex adds: offset runs from the corner to the place, direction is the corner's gradient.
Noise noise_corner(vec3 offset, vec3 direction) {
  float reach = max(0.5 - dot(offset, offset), 0.0);
  float ramp = dot(direction, offset);
  float reach2 = reach * reach;
  Noise n;
  n.value = reach2 * reach * ramp;
  n.gradient = reach2 * (reach * direction - 6.0 * ramp * offset);
  return n;
}

struct Simplex {
  uvec3 key0, key1, key2, key3;  // of the cells of the four corners around a place
  vec3 offset0, offset1, offset2, offset3;
};

// The simplex that holds the place q of a cell.
Simplex simplex_of(ivec3 cell, vec3 q) {
  vec3 base = floor(q + (q.x + q.y + q.z) * (1.0 / 3.0));
  vec3 x = q - base + (base.x + base.y + base.z) * (1.0 / 6.0);
  bool xy = x.x >= x.y;
  bool yz = x.y >= x.z;
  bool xz = x.x >= x.z;
  bvec3 most = bvec3(xy && xz, !xy && yz, !xz && !yz);
  bvec3 two = bvec3(xy || xz, !xy || yz, !xz || !yz);
  Simplex s;
  s.key0 = cell_key(cell + ivec3(base));
  s.key1 = s.key0 + uvec3(most.x ? cell_step.x : 0u, most.y ? cell_step.y : 0u, most.z ? cell_step.z : 0u);
  s.key2 = s.key0 + uvec3(two.x ? cell_step.x : 0u, two.y ? cell_step.y : 0u, two.z ? cell_step.z : 0u);
  s.key3 = s.key0 + cell_step;
  s.offset0 = x;
  s.offset1 = x - vec3(most) + 1.0 / 6.0;
  s.offset2 = x - vec3(two) + 1.0 / 3.0;
  s.offset3 = x - 0.5;
  return s;
}

// Scales the sum of the four corners to about -1..1 (tests/laws/noise_test.cpp measures the range).
const float noise_scale = 38.5;

// The mean square of the field's gradient along an axis, per cell (measured in tests/laws/heights_test.cpp).
const float noise_slope_square = 2.34;

Noise noise_of_corners(Noise a, Noise b, Noise c, Noise d) {
  Noise n;
  n.value = noise_scale * ((a.value + b.value) + (c.value + d.value));
  n.gradient = noise_scale * ((a.gradient + b.gradient) + (c.gradient + d.gradient));
  return n;
}

// The field itself, with fixed gradients. q: finite, within 1e6 cells of its cell's corner.
Noise simplex_noise(ivec3 cell, vec3 q, uint seed) {
  Simplex s = simplex_of(cell, q);
  uint key = seed_key(seed);
  return noise_of_corners(noise_corner(s.offset0, hash_direction(hash_key(s.key0, key))),
                          noise_corner(s.offset1, hash_direction(hash_key(s.key1, key))),
                          noise_corner(s.offset2, hash_direction(hash_key(s.key2, key))),
                          noise_corner(s.offset3, hash_direction(hash_key(s.key3, key))));
}

// The gradient of one corner, turned by an angle given as its cosine and sine. What turns is clouds and ripples: that its
// length is within a thousandth of 1 is enough. It turns towards a tangent of lib/tangent.glsl, with x and y exchanged and
// to the other side by chance: towards that alone, a quarter of a turn would leave all gradients along x.
vec3 turned_direction(uint h, vec2 turn) {
  vec3 wanted = hash_octahedron(h);
  mediump float square = dot(wanted, wanted);
  vec3 direction = inversesqrt(square) * wanted;
  bool exchanged = (h & 1u) != 0u;
  float x = exchanged ? direction.y : direction.x;
  float y = exchanged ? direction.x : direction.y;
  vec3 tangent = perpendicular(vec3(x, y, direction.z));
  float to_side = (h & 2u) != 0u ? turn.y : -turn.y;
  x = exchanged ? tangent.y : tangent.x;
  y = exchanged ? tangent.x : tangent.y;
  return turn.x * direction + to_side * vec3(x, y, tangent.z);
}

// The field with every gradient turned by an angle, given as its cosine and sine.
Noise turned_noise(ivec3 cell, vec3 q, vec2 turn, uint seed) {
  Simplex s = simplex_of(cell, q);
  uint key = seed_key(seed);
  return noise_of_corners(noise_corner(s.offset0, turned_direction(hash_key(s.key0, key), turn)),
                          noise_corner(s.offset1, turned_direction(hash_key(s.key1, key), turn)),
                          noise_corner(s.offset2, turned_direction(hash_key(s.key2, key), turn)),
                          noise_corner(s.offset3, turned_direction(hash_key(s.key3, key), turn)));
}

// The same from the angle (rad, any; reduce it to one turn on the host). Period 2 pi in angle.
Noise flow_noise(ivec3 cell, vec3 q, float angle, uint seed) {
  return turned_noise(cell, q, vec2(cos(angle), sin(angle)), seed);
}

// Three whole numbers, 0 to 1023, from the bits of a hash.
vec3 hash_parts(uint h) {
  return vec3(float(h & 1023u), float((h >> 10) & 1023u), float((h >> 20) & 1023u));
}

// Where layer i of a stack begins, in cells: layers that share an origin would all be zero there. Multiples of 1/1024,
// exact in single precision.
vec3 layer_offset(int layer, uint seed) {
  return hash_parts(hash_cell(ivec3(layer, 7, 13), seed)) / 1024.0;
}

// The seed of layer i.
uint layer_seed(int layer, uint seed) {
  return seed * 32u + uint(layer);
}

// A sum of octaves (Sandahl 2022, equations 1 and 2), one at a time.
struct OctaveSum {
  float sum;
  float amplitude;  // of the next octave
  float total;      // of the amplitudes so far
};

OctaveSum no_octaves() {
  OctaveSum s;
  s.sum = 0.0;
  s.amplitude = 1.0;
  s.total = 0.0;
  return s;
}

// persistence: amplitude of an octave by that of the one before.
void add_octave(inout OctaveSum s, float value, float persistence) {
  s.sum += s.amplitude * value;
  s.total += s.amplitude;
  s.amplitude *= persistence;
}

// The mean (1); 0 without octaves.
float octave_mean(OctaveSum s) {
  return s.total == 0.0 ? 0.0 : s.sum / s.total;
}

// The sum of the amplitudes of count layers, each persistence times as strong as the one before.
float amplitude_sum(float persistence, int count) {
  float n = float(count);
  return abs(persistence - 1.0) < 1.0e-3 ? n : (1.0 - pow(persistence, n)) / (1.0 - persistence);
}

// How much of a layer a grid or a picture can show, 0..1: all of it from four samples a cell on, nothing below two.
// frequency: cells per radian; footprint: distance of neighbouring samples, rad.
float layer_weight(float frequency, float footprint) {
  return 1.0 - smoothstep(0.25, 0.5, frequency * footprint);
}
