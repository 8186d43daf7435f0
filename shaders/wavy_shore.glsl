// A sea of waves by a shore of nodes, shore_nodes.glsl standing before it.
#include "wavy_nodes.glsl"
#include "felt_ground.glsl"

// As the waves are where the sun's refracted ray to the bottom enters the water; the shore is a plane from the pixel's place to there.
vec3 gathered_on_bottom(vec3 sunlight, vec3 to_bottom, float depth, LightAt at, SceneLight scene) {
  float shown = pattern_shown(sunlight);
  if (shown <= 0.0 || depth <= 0.0) return vec3(0.0);
  vec3 down = refracted_ray(-scene.sun, at.up, water_look());
  float way = depth / dive_of(down, at.up);
  vec3 aside = to_bottom - way * down;
  aside -= dot(aside, at.up) * at.up;
  SeaAt above = still_sea(still_from_eye + aside);
  above.shore.depth -= dot(felt_slope(above.frame), along_axes(aside, above.frame));
  above.gathers = true;
  float footprint = pixel_footprint(above.up, surface_from_eye, 0.1);
  vec3 parts = parts_of_regions(above.up);
  for (int k = 0; k < wave_axes.w; ++k) add_short_waves(above, k, part_of_region(k, parts), 0, all_short_waves, footprint);
  float left = wave_part_over_ground(above.shore.depth);
  return shown * (gathered_light(above.lens, left, way, water_refraction_index) - 1.0) * sunlight;
}

// Two layers of the ground's noise, as small as the sea's waves are high.
FoamLace foam_lace(float footprint) {
  FoamLace lace = no_lace();
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
