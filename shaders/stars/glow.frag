// The glow of far stars: warm where it is faint, for dust reddens it.
#include "sky_light.glsl"
#include "output.glsl"

in vec4 glow;

void main() {
  vec3 color = mix(vec3(1.0, 0.86, 0.72), vec3(0.72, 0.84, 1.1), glow.w);
  emit_veil(color * (0.085 * glow.w * stars_brightness * sky_shown(normalize(glow.xyz))), 0.0);
}
