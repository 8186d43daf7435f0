#include "output.glsl"

in vec3 star_light;
in float star_radius;

void main() {
  // A soft disc, smooth at any place between pixels.
  float r = length(gl_PointCoord - 0.5) * (2.0 * star_radius + 2.0) / star_radius;
  emit_veil(star_light * exp(-2.4 * r * r) * step(r, 2.0), 0.0);
}
