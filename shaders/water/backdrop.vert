// The whole picture.
#include "frame_block.glsl"

uniform float nearness;  // clip z

out vec3 view_ray;

void main() {
  vec2 corner = vec2(float((gl_VertexID & 1) * 4 - 1), float((gl_VertexID >> 1) * 4 - 1));
  view_ray = ray_forward.xyz + corner.x * ray_right.xyz + corner.y * ray_up.xyz;
  gl_Position = vec4(corner, nearness, 1.0);
}
