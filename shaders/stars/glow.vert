// The glow of far stars, at infinity: a belt whose vertices tell how bright it is. Warm where it is faint, for dust reddens
// it.
#include "sky_light.glsl"

layout(location = 0) in vec3 vertex;  // direction times (1 + brightness)

out vec3 glow;  // its light

void main() {
  float length_of = length(vertex);
  vec3 direction = vertex / length_of;
  float bright = length_of - 1.0;
  vec3 color = mix(vec3(1.0, 0.86, 0.72), vec3(0.72, 0.84, 1.1), bright);
  glow = color * (0.085 * bright * stars_brightness * sky_shown(direction));
  vec4 place = clip_from_eye * vec4(direction, 0.0);
  gl_Position = vec4(place.xy, place.w, place.w);  // at the far plane
}
