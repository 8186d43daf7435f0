// A small light: a soft disc, smooth at any place between pixels.
#include "output.glsl"

in vec3 square_light;
in vec2 square_place;

void main() {
  float r2 = dot(square_place, square_place);
  emit_veil(square_light * max(exp(-1.8 * r2) - exp(-1.8 * 4.0), 0.0), 0.0);
}
