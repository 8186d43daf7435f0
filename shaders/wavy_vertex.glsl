// A vertex of a sea of waves over a ground of nodes.
#include "node_vertex.glsl"
#include "node_waves.glsl"

out vec3 still_from_eye;
out vec3 surface_from_eye;
// What the vertices carry of the waves: pixels go on with the others. x: height; y, z: slope; w: stretch_nn of WaveSum
out vec4 carried_slope;
out vec2 carried_before;  // x: before of WaveSum; y: stretch_before
out vec4 carried_stretch;  // x, y: shift; z, w: stretch_ee, stretch_en, and as much is stretch_ne

// As the ground leaves them.
WaveSum waves_at_vertex(WaveSum sum, Frame f);

void main() {
  NodeVertex v = node_vertex();
  still_from_eye = node_sea.xyz + sea.x * v.flat_place;
  SeaAt at = still_sea(still_from_eye);
  // Of deep nodes every second vertex is drawn. As far apart as those are where this one is, whatever the node's level.
  float footprint = 2.0 * node_around.w * (1.0 + node_held.y);
  vec3 parts = parts_of_regions(at.up);
  for (int k = 0; k < wave_axes.w; ++k) add_short_waves(at, k, part_of_region(k, parts), 0, first_of_pixel, footprint);
  carried_slope = vec4(at.sum.height, at.sum.slope, at.sum.stretch_nn);
  carried_before = vec2(at.sum.before, at.sum.stretch_before);
  carried_stretch = vec4(at.sum.shift, at.sum.stretch_ee, at.sum.stretch_en);
  for (int k = 0; k < wave_axes.w; ++k)
    add_short_waves(at, k, part_of_region(k, parts), first_of_pixel, all_short_waves, footprint);
  float unseen = 0.0;
  for (int i = 0; i < int(sea.z); ++i) add_long_wave(at.sum, unseen, at.up, at.frame, i, footprint);
  surface_from_eye = still_from_eye + wave_offset(at.up, at.frame, waves_at_vertex(at.sum, at.frame));
  float away = length(surface_from_eye);
  surface_from_eye += away * v.skirt + min(levels.y * away, levels.w) * v.up;
  gl_Position = clip_at(surface_from_eye);
}
