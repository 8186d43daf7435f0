// A calm sea whose ripples are too small to be seen: they only widen the glitter.
#include "calm_water.glsl"

void main() {
  vec3 up = water_direction();
  Ripples r;
  r.gradient = vec3(0.0);
  r.rough = unseen_roughness(first_ripple, 0.0) + unseen_roughness(next_ripple * first_ripple, 0.0);
  r.wash = 0.0;
  r.crust = water_crust;
  emit_calm_water(r, up);
}
