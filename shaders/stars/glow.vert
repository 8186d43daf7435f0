// The glow of far stars, at infinity: a belt whose vertices tell how bright it is.
#include "scene_block.glsl"
#include "frame_block.glsl"

layout(location = 0) in vec3 vertex;  // direction times (1 + brightness)

out vec4 glow;  // xyz: direction; w: brightness, 0..1

void main() {
  float length_of = length(vertex);
  glow = vec4(vertex / length_of, length_of - 1.0);
  vec4 place = clip_from_eye * vec4(glow.xyz, 0.0);
  gl_Position = vec4(place.xy, place.w, place.w);  // at the far plane
}
