// Sunlight that waves gather on the bottom.
#include "node_waves.glsl"
#include "water_look.glsl"

// How much of it there is more than under a still sea, as a part of that: as the waves are where the sun's refracted ray to the
// bottom enters the water. still: a place of the still water under which the ground is known, from the eye; the shore is a plane from
// there on; to_bottom: from it; depth: of the bottom; footprint: between samples of it, rad; up: unit.
float gathered_below(vec3 still, vec3 to_bottom, float depth, float footprint, vec3 up, SceneLight scene) {
  if (depth <= 0.0) return 0.0;
  vec3 down = refracted_ray(-scene.sun, up, water_look());
  float way = depth / dive_of(down, up);
  vec3 aside = to_bottom - way * down;
  aside -= dot(aside, up) * up;
  SeaAt above = still_sea(still + aside);
  above.shore.depth -= dot(felt_slope(above.frame), along_axes(aside, above.frame));
  above.gathers = true;
  vec3 parts = parts_of_regions(above.up);
  for (int k = 0; k < wave_axes.w; ++k) add_short_waves(above, k, part_of_region(k, parts), 0, all_short_waves, footprint);
  float left = left_ashore(above.shore.depth, sea.w);
  return gathered_light(above.lens, left, way, water_refraction_index) - 1.0;
}
