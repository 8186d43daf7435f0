// Impact craters: bowls with raised rims, strewn over the sphere in several sizes. Each size has a lattice of cells of its
// own; the craters of the cells through which the sphere passes are moved onto it.
#include "lib/noise.glsl"

struct Craters {
  float depth;      // as a part of that of fresh craters, 0..1; 0: there are none
  float frequency;  // cells of the largest, per radius; a crater is 0.2 to 0.56 cells wide
  int sizes;        // 0..16, the cells of each 0.7 times as wide as those of the one before
  uint seed;
};

// What a crater is at a distance from its centre.
struct CraterShape {
  float height;  // in depths: -1 at the centre, about 0.2 on the rim
  float slope;   // its derivative by the distance in crater radii
};

// Distance (in crater radii) at which the ground around a crater is as it was.
const float crater_reach = 1.5;

// How far (in cells) a centre may be from the sphere. Together with the largest crater's reach, at a right angle, it stays
// below half a cell: only the eight cells around a place can reach it.
const float crater_shell = 0.25;

// distance: from the centre, in crater radii, >= 0. Smooth all over, so that no rim aliases more than the noise does.
CraterShape crater_shape(float distance) {
  float inside = max(1.0 - distance * distance, 0.0);
  float t = clamp((distance - 1.0) / (crater_reach - 1.0), -1.0, 1.0);
  float rim = 1.0 - t * t;
  CraterShape shape;
  shape.height = 0.22 * rim * rim - inside * inside;
  shape.slope = 4.0 * distance * inside - 0.88 * t * rim / (crater_reach - 1.0);
  return shape;
}

// The crater of one cell.
struct Crater {
  vec3 centre;   // unit
  float radius;  // cells
  float depth;   // cells; 0: there is none
};

// frequency: cells per radius.
Crater crater_of(ivec3 cell, float frequency, uint seed) {
  Crater crater;
  crater.depth = 0.0;
  vec3 centre = vec3(cell) + hash_parts(hash_cell(cell, seed)) / 1023.0;
  float from_origin = length(centre);
  if (abs(from_origin - frequency) > crater_shell || from_origin < 0.5) return crater;
  vec3 dice = hash_parts(hash_cell(cell, seed + 77u)) / 1023.0;
  crater.centre = centre / from_origin;
  crater.radius = 0.10 + 0.18 * dice.x * dice.x;
  // Old craters have been levelled.
  crater.depth = 0.4 * crater.radius * mix(0.3, 1.0, dice.y);
  return crater;
}

// The seed of the craters of size i.
uint crater_seed(int i, uint seed) {
  return layer_seed(i, seed + 4409u);
}

// Adds the crater of one cell to a height and its gradient over the unit sphere, both in cells of its size.
void add_crater(vec3 direction, float frequency, ivec3 cell, uint seed, inout float height, inout vec3 gradient) {
  Crater crater = crater_of(cell, frequency, seed);
  if (crater.depth <= 0.0) return;
  vec3 offset = direction - crater.centre;
  float away = length(offset) * frequency / crater.radius;
  if (away >= crater_reach) return;
  CraterShape shape = crater_shape(away);
  height += crater.depth * shape.height;
  gradient += (crater.depth * shape.slope * frequency / (crater.radius * max(length(offset), 1.0e-9))) * offset;
}

// Craters are as fine as layers of noise with so many times the cells.
const float crater_detail = 2.5;

// How much of craters samples a footprint (rad) apart can show, 0..1. frequency: of their cells.
float crater_weight(float frequency, float footprint) {
  return layer_weight(crater_detail * frequency, footprint);
}

// Sizes of craters follow each other by this factor of their frequencies.
const float crater_step = 1.41421356;

// Adds the craters of one size, as strongly as shown says, to what add_craters does. frequency: of their cells.
void add_craters_of_size(vec3 direction, int size, float frequency, uint seed, float shown, inout float height,
                         inout vec3 gradient) {
  ivec3 cell = ivec3(floor(direction * frequency - 0.5));
  float dug = 0.0;
  vec3 slope = vec3(0.0);
  for (int k = 0; k < 8; ++k) {
    ivec3 corner = ivec3(k & 1, (k >> 1) & 1, k >> 2);
    add_crater(direction, frequency, cell + corner, crater_seed(size, seed), dug, slope);
  }
  height += shown * dug / frequency;
  gradient += (shown / frequency) * slope;
}

// Adds all craters at a direction (unit) to a height (planet radii) and its gradient over the unit sphere, without those
// that samples a footprint (rad) apart can't show.
void add_craters(vec3 direction, Craters c, float footprint, inout float height, inout vec3 gradient) {
  float frequency = c.frequency;
  for (int i = 0; i < c.sizes; ++i) {
    float shown = c.depth * crater_weight(frequency, footprint);
    if (shown <= 0.0) break;  // and so is that of all smaller ones
    add_craters_of_size(direction, i, frequency, c.seed, shown, height, gradient);
    frequency *= crater_step;
  }
}
