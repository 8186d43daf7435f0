// The glow of far stars.
#include "output.glsl"

in vec3 glow;

void main() {
  emit_veil(glow, 0.0);
}
