// A sea of waves over a ground of nodes.
#include "node_no_map.glsl"
#include "shore_nodes.glsl"
#include "wavy_nodes.glsl"
#include "felt_ground.glsl"

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
