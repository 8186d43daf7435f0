// The air where nothing is behind it but the sky; surfaces take the air before them into account themselves.
#include "light_block.glsl"
#include "output.glsl"

in vec3 view_ray;

void main() {
  Veil veil = air_before_sky(normalize(view_ray), scene_light());
  emit_veil(veil.light, veil.opacity);
}
