// A square around the sun, at infinity.
#include "scene_block.glsl"
#include "frame_block.glsl"

uniform float reach;  // tangent of the angle between the sun's middle and the square's sides

out vec2 sun_place;  // tangents

void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  sun_place = corner * reach;
  vec4 place = clip_from_eye * vec4(sun_direction.xyz, 0.0);
  place.xy += sun_place / vec2(length(ray_right.xyz), length(ray_up.xyz)) * place.w;
  gl_Position = vec4(place.xy, place.w, place.w);  // at the far plane
}
