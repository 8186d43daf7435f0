// A sea of waves by a shore of nodes, shore_nodes.glsl standing before it.
#include "wavy_nodes.glsl"
#include "felt_ground.glsl"

// The shore is a plane from the pixel's place to where the light enters.
float gathered_on_bottom(vec3 sunward, float way) {
  SeaAt above = still_sea(still_from_eye + sunward);
  vec2 aside = vec2(dot(sunward, above.frame.east), dot(sunward, above.frame.north));
  above.shore.depth -= dot(felt_slope(above.frame), aside);
  above.gathers = true;
  float footprint = pixel_footprint(above.up, surface_from_eye, 0.1);
  vec3 parts = parts_of_regions(above.up);
  for (int k = 0; k < wave_axes.w; ++k) add_short_waves(above, k, part_of_region(k, parts), 0, all_short_waves, footprint);
  return gathered_light(above.lens, wave_part_over_ground(above.shore.depth), way, water_refraction_index);
}

// Two layers of the ground's noise, as small as the sea's waves are high.
FoamLace foam_lace(float footprint) {
  FoamLace lace;
  lace.noise = 0.0;
  lace.shown = 0.0;
  int first = int(wave_shore.w);
  if (first < 0) return lace;
  lace.shown = layer_weight(layer_place[first].w, footprint);
  if (lace.shown <= 0.0) return lace;
  vec3 from_anchor = direction_from_anchor(still_from_eye);
  float finer = layer_weight(layer_place[first + 1].w, footprint);
  float fine = finer > 0.0 ? layer_noise(first + 1, from_anchor).value : 0.0;
  lace.noise = lace_of(layer_noise(first, from_anchor).value, fine, finer);
  return lace;
}
