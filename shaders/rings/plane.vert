// An annulus around the planet in the plane of its equator, as a strip.
#include "scene_block.glsl"
#include "frame_block.glsl"

uniform float corners;

out vec3 ring_from_eye;

void main() {
  float side = float(gl_VertexID & 1);
  float turn = 6.283185307179586 * float(gl_VertexID >> 1) / corners;
  // A little wider than the rings, so that its straight edges touch their circles.
  float radius = mix(rings_inner * cos(3.141592653589793 / corners), rings_outer / cos(3.141592653589793 / corners), side);
  ring_from_eye = from_eye(radius * vec3(cos(turn), sin(turn), 0.0));
  gl_Position = clip_at(ring_from_eye);
}
