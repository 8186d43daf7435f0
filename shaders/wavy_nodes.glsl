// A sea of waves over a ground of nodes, shore_nodes.glsl or deep_nodes.glsl standing before it; the normal is exact at every
// pixel but for what straight lines between vertices miss of the waves that those carry.
#include "node_waves.glsl"
#include "water_surface.glsl"
#include "lib/open_water.glsl"

in vec3 still_from_eye;
in vec4 carried_slope;
in vec2 carried_before;
in vec4 carried_stretch;

// What tears the foam of surf at the pixel.
FoamLace foam_lace(float footprint);

vec3 water_place() { return still_from_eye; }

Breaking sea_breaking() {
  Breaking b;
  b.fold = wave_breaking.x;
  b.softness = wave_breaking.y;
  b.choppiness = wave_breaking.z;
  return b;
}

WaveSum carried_waves() {
  WaveSum sum;
  sum.height = carried_slope.x;
  sum.before = carried_before.x;
  sum.stretch_before = carried_before.y;
  sum.slope = carried_slope.yz;
  sum.stretch_nn = carried_slope.w;
  sum.shift = carried_stretch.xy;
  sum.stretch_ee = carried_stretch.z;
  sum.stretch_en = carried_stretch.w;
  sum.stretch_ne = carried_stretch.w;
  return sum;
}

void main() {
  float depth = depth_below(vec3(0.0));
  SeaAt at = still_sea(still_from_eye);
  vec3 parts = parts_of_regions(at.up);
  at.sum = carried_waves();
  // By how the long waves face the eye.
  vec3 facing = normalize(at.up - at.sum.slope.x * at.frame.east - at.sum.slope.y * at.frame.north);
  float footprint = pixel_footprint(side_of_eye(facing), surface_from_eye, 0.1);
  float unseen = 0.0;
  for (int k = 0; k < wave_axes.w; ++k) {
    float part = part_of_region(k, parts);
    unseen += part * part * variance_from(k, first_of_pixel);
    add_short_waves(at, k, part, first_of_pixel, all_short_waves, footprint);
  }
  unseen = max(unseen - 0.5 * at.seen, 0.0);
  for (int i = 0; i < int(sea.z); ++i) add_long_wave(at.sum, unseen, at.up, at.frame, i, footprint);
  float left = wave_part_over_ground(depth);
  at.sum = waves_over_ground(at.sum, at.frame, depth);
  // High waves are long, and the last that are no longer shown.
  float part = min(unseen / wave_shore.z, 1.0);
  Unseen other;
  other.slopes = left * left * unseen;
  other.heights = 0.5 * left * left * sea.y * sea.y * part * part * part * part;
  Water water = open_water(at.up, -normalize(surface_from_eye), begins_in_water(surface_from_eye), depth, at.sum, at.frame, other, sea_breaking(), foam_lace(footprint), sea.w, water_look());
  emit_water(water, at.up, at.sum.height);
}
