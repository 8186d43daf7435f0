// A sea of waves over deep nodes.
#include "deep_nodes.glsl"
#include "wavy_nodes.glsl"
#include "no_felt_ground.glsl"

// No surf.
FoamLace foam_lace(float footprint) {
  FoamLace lace;
  lace.noise = 0.0;
  lace.shown = 0.0;
  return lace;
}
