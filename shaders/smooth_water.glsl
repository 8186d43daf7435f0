// A calm sea whose ripples are too small to be seen: they only widen the glitter.
#include "calm_water.glsl"

void main() {
  Ripples r = no_ripples(water_ripple_frequency, vec2(1.0, 0.0));
  for (int i = 0; i < told_ripples; ++i) r = next_layer(roughened(r, water_ripples, 0.0));
  emit_calm_water(r, water_crust, water_direction());
}
