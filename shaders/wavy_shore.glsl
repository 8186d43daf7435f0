// A sea of waves by a shore of nodes, shore_nodes.glsl standing before it.
#include "wavy_nodes.glsl"
#include "felt_ground.glsl"
#include "wavy_bottom.glsl"

vec3 gathered_on_bottom(vec3 sunlight, vec3 to_bottom, float depth, float footprint, LightAt at, SceneLight scene) {
  float shown = pattern_shown(sunlight);
  if (shown <= 0.0) return vec3(0.0);
  return shown * gathered_below(still_from_eye, to_bottom, depth, footprint, at.up, scene) * sunlight;
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
