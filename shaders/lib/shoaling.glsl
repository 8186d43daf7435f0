// Waves that run up a shore: the shallower the water, the shorter they are, and so they turn towards it, break, and run up and
// down the land. Lengths in planet radii.
#include "lib/waves.glsl"

// The ground under a place as waves feel it.
struct Shore {
  float depth;       // of the still water; at most 0: land
  vec2 rise;         // slope of the ground along two axes, times per_slope
  float per_slope;   // 1 over how steep the planet's shores usually are
  float felt_depth;  // from which on waves run as if there were no ground
};

// How a wave runs where it feels the ground.
struct Shoaling {
  float phase;  // gained on the way
  vec2 turn;    // added to its direction in deep water (unit): the sum is as many times as long as the wave is shorter
};

// Depth times wavenumber in deep water at which a wave is a quarter as long as there, and no shorter: water in which it would be
// runs up and down the land as a sheet.
const float shortest_depth = 0.06258157147700301;

// Root of the hyperbolic tangent of a depth times a wavenumber in deep water, 0.25..1.
float shallowness(float depth) {
  return max(sqrt(tanh(clamp(depth, 0.0, 10.0))), 0.25);
}

// How many times as short a wave of such a shallowness is, 1..4: Eckart's solution (1952) of the dispersion relation, 5 % off at the
// most down to shortest_depth; at the still waterline 1 again. depth: times the wavenumber in deep water.
float shortened_at(float depth, float shallow) {
  return 1.0 + (1.0 / shallow - 1.0) * smoothstep(0.0, shortest_depth, depth);
}
float shortened(float depth) { return shortened_at(depth, shallowness(depth)); }

// Integral over depth, from one on, of shortened less 1: what a wave's phase gains on the way up a slope of 1, rad.
float gained_at(float depth, float shallow) {
  float y = clamp(depth / shortest_depth, 0.0, 1.0);
  float sheet = 3.0 * shortest_depth * (0.5 - y * y * y * (1.0 - 0.5 * y));
  float whole = 1.0 + shallow;
  return 1.1319717536774210 - 0.5 * log(whole * whole / (1.0 + shallow * shallow)) - atan(shallow) + sheet;
}
float gained_phase(float depth) { return gained_at(depth, shallowness(depth)); }

// wavenumber: in deep water, rad per radius; begins: gained_phase where the wave begins to feel the ground.
Shoaling shoaling(float wavenumber, float begins, Shore shore) {
  Shoaling s;
  s.phase = 0.0;
  s.turn = vec2(0.0);
  if (shore.depth >= shore.felt_depth) return s;
  float depth = wavenumber * shore.depth;
  float shallow = shallowness(depth);
  s.phase = (gained_at(depth, shallow) - begins) * shore.per_slope;
  s.turn = (shortened_at(depth, shallow) - 1.0) * shore.rise;
  return s;
}

// How far over the still water waves run up the land, as a part of the depth at which they are whole.
const float run_up = 0.1111111111111111;

// Where a depth lies between what waves reach, 0, and where they are whole, 1. depth: of the still water; whole_depth: > 0.
float part_ashore(float depth, float whole_depth) {
  return clamp((depth / whole_depth + run_up) / (1.0 + run_up), 0.0, 1.0);
}

// How much of its waves a shore leaves, 0..1: a fifth where the still water ends.
float left_ashore(float depth, float whole_depth) {
  float x = part_ashore(depth, whole_depth);
  return x * (2.0 - x);
}

// Waves as they are at a shore. gradient: of the ground's height, in the axes that the frame has.
WaveSum held_ashore(WaveSum sum, Frame frame, float depth, vec3 gradient, float whole_depth) {
  float x = part_ashore(depth, whole_depth);
  float per_height = x > 0.0 ? -2.0 * (1.0 - x) / ((1.0 + run_up) * whole_depth) : 0.0;
  return attenuate(sum, left_ashore(depth, whole_depth), per_height * along_axes(gradient, frame));
}
