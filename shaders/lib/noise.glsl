// Simplex noise in three dimensions whose gradients can be turned (Gustavson & McEwan, "Tiling simplex noise and flow
// noise in two and three dimensions"; Sandahl 2022, sections 2.1 to 2.3).
//
// A place is given as a cell of the skewed lattice (integers) and a position q relative to that cell's corner, in cells.
// noise(cell, q) is the same field whichever cell it is told from, so a caller far from the origin chooses a cell close
// by and keeps its precision. The lattice repeats only where 32-bit integers do.

struct Noise {
  float value;    // about -1 to 1; |value| can pass 1 by a hundredth
  vec3 gradient;  // of value by position, per cell
};

// A well mixed integer from a cell and a seed: the same on every machine.
uint hash_cell(ivec3 cell, uint seed) {
  uint h = uint(cell.x) * 0x8da6b343u ^ uint(cell.y) * 0xd8163841u ^ uint(cell.z) * 0xcb1ab31fu ^ seed * 0x9e3779b9u;
  h ^= h >> 16;
  h *= 0x7feb352du;
  h ^= h >> 15;
  h *= 0x846ca68bu;
  return h ^ (h >> 16);
}

// A unit vector from 32 random bits, spread over the sphere by an octahedron: no direction of the lattice is preferred.
vec3 hash_direction(uint h) {
  float x = float(h & 0xffffu) / 32767.5 - 1.0;
  float y = float(h >> 16) / 32767.5 - 1.0;
  float z = 1.0 - abs(x) - abs(y);
  float fold = max(-z, 0.0);
  x += x >= 0.0 ? -fold : fold;
  y += y >= 0.0 ? -fold : fold;
  return normalize(vec3(x, y, z));
}

// A unit vector at right angles to n (Duff et al. 2017, "Building an orthonormal basis, revisited").
vec3 perpendicular(vec3 n) {
  float side = n.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (side + n.z);
  return vec3(1.0 + side * n.x * n.x * a, side * n.x * n.y * a, -side * n.x);
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
  ivec3 cell0, cell1, cell2, cell3;  // the four corners around a place
  vec3 offset0, offset1, offset2, offset3;
};

// The simplex that holds the place q of a cell.
Simplex simplex_of(ivec3 cell, vec3 q) {
  vec3 base = floor(q + (q.x + q.y + q.z) / 3.0);
  vec3 x = q - base + (base.x + base.y + base.z) / 6.0;
  bool xy = x.x >= x.y;
  bool yz = x.y >= x.z;
  bool xz = x.x >= x.z;
  ivec3 most = ivec3(xy && xz ? 1 : 0, !xy && yz ? 1 : 0, !xz && !yz ? 1 : 0);
  ivec3 two = ivec3(xy || xz ? 1 : 0, !xy || yz ? 1 : 0, !xz || !yz ? 1 : 0);
  Simplex s;
  s.cell0 = cell + ivec3(base);
  s.cell1 = s.cell0 + most;
  s.cell2 = s.cell0 + two;
  s.cell3 = s.cell0 + ivec3(1);
  s.offset0 = x;
  s.offset1 = x - vec3(most) + 1.0 / 6.0;
  s.offset2 = x - vec3(two) + 1.0 / 3.0;
  s.offset3 = x - 0.5;
  return s;
}

// Scales the sum of the four corners to about -1..1 (tests/laws/noise_test.cpp measures the range).
const float noise_scale = 38.5;

// The field itself, with fixed gradients. q: finite, within 1e6 cells of its cell's corner.
Noise simplex_noise(ivec3 cell, vec3 q, uint seed) {
  Simplex s = simplex_of(cell, q);
  Noise a = noise_corner(s.offset0, hash_direction(hash_cell(s.cell0, seed)));
  Noise b = noise_corner(s.offset1, hash_direction(hash_cell(s.cell1, seed)));
  Noise c = noise_corner(s.offset2, hash_direction(hash_cell(s.cell2, seed)));
  Noise d = noise_corner(s.offset3, hash_direction(hash_cell(s.cell3, seed)));
  Noise n;
  n.value = noise_scale * ((a.value + b.value) + (c.value + d.value));
  n.gradient = noise_scale * ((a.gradient + b.gradient) + (c.gradient + d.gradient));
  return n;
}

// The gradient of one corner, turned by an angle given as its cosine and sine.
vec3 turned_direction(ivec3 cell, uint seed, float cosine, float sine) {
  vec3 direction = hash_direction(hash_cell(cell, seed));
  return cosine * direction + sine * perpendicular(direction);
}

// The field with every gradient turned by angle (rad, any; reduce it to one turn on the host). Period 2 pi in angle.
Noise flow_noise(ivec3 cell, vec3 q, float angle, uint seed) {
  Simplex s = simplex_of(cell, q);
  float cosine = cos(angle);
  float sine = sin(angle);
  Noise a = noise_corner(s.offset0, turned_direction(s.cell0, seed, cosine, sine));
  Noise b = noise_corner(s.offset1, turned_direction(s.cell1, seed, cosine, sine));
  Noise c = noise_corner(s.offset2, turned_direction(s.cell2, seed, cosine, sine));
  Noise d = noise_corner(s.offset3, turned_direction(s.cell3, seed, cosine, sine));
  Noise n;
  n.value = noise_scale * ((a.value + b.value) + (c.value + d.value));
  n.gradient = noise_scale * ((a.gradient + b.gradient) + (c.gradient + d.gradient));
  return n;
}

// Where layer i of a stack begins, in cells: layers that share an origin would all be zero there. Multiples of 1/1024,
// exact in single precision.
vec3 layer_offset(int layer, uint seed) {
  uint h = hash_cell(ivec3(layer, 7, 13), seed);
  return vec3(float(h & 1023u), float((h >> 10) & 1023u), float((h >> 20) & 1023u)) / 1024.0;
}

// The seed of layer i.
uint layer_seed(int layer, uint seed) {
  return seed * 32u + uint(layer);
}
