// Worley's cellular noise (Worley 1996): how far the nearest of points scattered over cubic cells is, one point a cell.
#include "lib/noise.glsl"

struct Worley {
  float nearest;  // F1, 0 to sqrt(3)
  float second;   // F2 >= F1
  vec3 gradient;  // of F1, per cell: a unit vector, 0 at the point itself
};

// q: place relative to a cell's corner, in cells. Looks two cells around: no point that is nearer than the one in the own
// cell can be missed.
Worley worley_noise(ivec3 cell, vec3 q, uint seed) {
  vec3 base = floor(q);
  vec3 place = q - base;
  ivec3 home = cell + ivec3(base);
  float least = 100.0;  // squares
  float next = 100.0;
  vec3 toward = vec3(0.0);
  for (int i = 0; i < 125; ++i) {
    ivec3 side = ivec3(i % 5, (i / 5) % 5, i / 25) - 2;
    vec3 point = (hash_parts(hash_cell(home + side, seed)) + 0.5) / 1024.0;
    vec3 offset = place - (vec3(side) + point);
    float square = dot(offset, offset);
    next = min(next, max(square, least));
    toward = square < least ? offset : toward;
    least = min(least, square);
  }
  Worley w;
  w.nearest = sqrt(least);
  w.second = sqrt(next);
  w.gradient = toward * (least > 0.0 ? inversesqrt(least) : 0.0);
  return w;
}
