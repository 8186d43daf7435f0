// The same where land stands in its mirror.
#include "deep_nodes.glsl"
#include "wavy_nodes.glsl"
#include "no_felt_ground.glsl"
#include "water_from_air.glsl"
#include "mirror_of_land.glsl"

// No surf.
FoamLace foam_lace(float footprint) { return no_lace(); }
