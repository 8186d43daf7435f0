// The glow of far stars, at infinity: a belt whose vertices tell how bright it is.
#include "light_block.glsl"
#include "lib/stars.glsl"

layout(location = 0) in vec3 vertex;  // direction times (1 + brightness)

out vec3 glow;  // its light

void main() {
  float length_of = length(vertex);
  vec3 direction = vertex / length_of;
  glow = band_light(length_of - 1.0, stars_brightness) * sky_shown(direction, scene_light());
  gl_Position = clip_along(direction);
}
