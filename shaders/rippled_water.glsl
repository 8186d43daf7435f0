// A calm sea with ripples of flow noise; close to it each layer carries a finer one.
#include "calm_water.glsl"

void main() {
  vec3 up = water_direction();
  float footprint = pixel_footprint(side_of_eye(up), surface_from_eye, 0.12);
  uint seed = ripple_seed(planet_seed);
  Ripples r = no_ripples(water_ripple_frequency, ripple_turn.xy);
  for (int layer = 0; layer < int(ripple_turn.z); ++layer) r = add_ripples(r, up, ripple.x, footprint, seed);
  emit_calm_water(r, torn_crust(r, layer_weight(water_ripple_frequency, footprint), water_look()), up);
}
