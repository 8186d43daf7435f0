// Ice that floats on the sea around the poles. It is ground that lies a little over the water: drawn like all ground, it
// costs a frame nothing.
#include "lib/noise.glsl"

struct Ice {
  float sea;   // height of the water over the sphere, radii; at most 0: no water
  float sine;  // of the latitude from which ice lies on it; above 1: nowhere
  float thickness;  // over the water, radii
  uint seed;
};

// Sine of the latitude (deg) from which on something lies around the poles; above 1 from 90 on: nowhere.
float polar_sine(float latitude) {
  return latitude < 90.0 ? sin(radians(latitude)) : 2.0;
}

// Height of ice over the water, radii: a fiftieth of the highest ground's, so that it is as flat beside mountains on a planet of
// real size as on a miniature. relief: of that ground, radii.
float ice_thickness(float relief) { return clamp(0.02 * relief, 1.0e-5, 0.0012); }

// The floe around a place: of strewn points the nearest one's cell (Worley 1996).
struct Floe {
  float from_rim;  // half by how much the next floe's point is further away, cells of floe_frequency
  float dice;      // 0..1, the same all over the floe
};

// Floes in a radius, about.
const float floe_frequency = 15.0;

// A floe's point, in a cell, and its dice. hash: of the cell.
vec3 floe_point(ivec3 cell, uint hash) { return vec3(cell) + hash_parts(hash) / 1023.0; }
float floe_dice(uint hash) { return float((hash >> 5) & 1023u) / 1023.0; }

// place: in cells.
Floe floe_at(vec3 place, uint seed) {
  ivec3 cell = ivec3(floor(place));
  float nearest = 4.0, second = 4.0;
  uint number = 0u;
  for (int i = 0; i < 27; ++i) {
    ivec3 beside = cell + ivec3(i % 3 - 1, (i / 3) % 3 - 1, i / 9 - 1);
    uint hash = hash_cell(beside, seed);
    float away = distance(place, floe_point(beside, hash));
    second = min(second, max(nearest, away));
    number = away < nearest ? hash : number;
    nearest = min(nearest, away);
  }
  Floe floe;
  floe.from_rim = 0.5 * (second - nearest);
  floe.dice = floe_dice(number);
  return floe;
}

// Cells in a radius of the bays along the ice's edge.
const float bays_frequency = 6.0;

Noise bays_noise(vec3 direction, Ice ice) {
  return simplex_noise(ivec3(0), bays_frequency * direction, ice.seed + 901u);
}

// How far a place lies within the ice's edge, but for floes. polar: sine of its latitude, without a sign; bays: value of
// bays_noise.
float within_edge(float polar, float bays, Ice ice) { return polar - ice.sine + 0.035 * bays; }

// What tells the points of floes from all other noise of a planet.
uint floe_seed(Ice ice) { return ice.seed + 902u; }

// From which dice on floes are missing, and half of how far apart they lie, radians, so far within the edge.
float dice_of_missing(float within) { return 0.45 + 0.6 * smoothstep(-0.03, 0.05, within); }
float floes_apart(float within) { return 0.006 * (1.0 - smoothstep(0.0, 0.12, within)); }

// What samples so far apart see of floes. within: the edge; floes: how far within one of them, or negative.
float seen_cover(float within, float floes, float footprint) {
  return min(within + 0.03, mix(within, floes, layer_weight(floe_frequency, footprint)));
}

// How far a place lies within the ice: negative beyond its edge and between floes, about in radians. The latitude decides
// and bays of noise: at the pole the ice is whole, towards its edge it breaks into floes that lie ever further apart, until
// some are missing. footprint: rad.
float ice_cover(vec3 direction, Ice ice, float footprint) {
  float within = within_edge(abs(direction.z), bays_noise(direction, ice).value, ice);
  Floe floe = floe_at(floe_frequency * direction, floe_seed(ice));
  float rim = floe.from_rim / floe_frequency;
  bool missing = floe.dice > dice_of_missing(within);
  return seen_cover(within, (missing ? -rim : rim) - floes_apart(within), footprint);
}

// Whether there can be ice at a place at all.
bool ice_near(vec3 direction, Ice ice) {
  return ice.sine <= 1.0 && ice.sea > 0.0 && abs(direction.z) > ice.sine - 0.08;
}

// Height of the ice's upper side over the sphere, radii; under water, of its foot, so that it ends in a slope.
float ice_height(float cover, Ice ice) {
  return ice.sea + clamp(cover, -0.04, ice.thickness);
}

// Raises a height over the sphere to that of ice which lies over it; says whether any does. footprint: rad.
bool raised_to_ice(inout float height, vec3 direction, Ice ice, float footprint) {
  if (!ice_near(direction, ice) || height >= ice.sea + ice.thickness) return false;
  float of_ice = ice_height(ice_cover(direction, ice, footprint), ice);
  if (of_ice <= height) return false;
  height = of_ice;
  return true;
}
