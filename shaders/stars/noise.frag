#include "output.glsl"

in vec3 star_light;
in vec2 star_place;

void main() {
  // A soft disc, smooth at any place between pixels.
  float r2 = dot(star_place, star_place);
  emit_veil(star_light * max(exp(-1.8 * r2) - exp(-1.8 * 4.0), 0.0), 0.0);
}
