#include "light_block.glsl"
#include "output.glsl"
#include "lib/sun.glsl"

uniform float radius;  // tangent of the sun's apparent radius
uniform float pixel;   // rad, where the sun stands
uniform float reach;   // as in the vertex stage
uniform float disc;    // brightness of each
uniform float glare;

in vec3 sun_ray;

void main() {
  float away = tangent_from_sun(sun_ray, sun_direction.xyz);
  float shape = disc * disc_of_sun(away, radius, pixel) + glare * glare_of_sun(away, radius, reach);
  emit_veil(sunlight_at_eye(scene_light()) * shape, 0.0);
}
