#include "lib/cube.glsl"

uniform int face;

out vec3 cube_direction;

void main() {
  vec2 corner = vec2(float((gl_VertexID & 1) * 4 - 1), float((gl_VertexID >> 1) * 4 - 1));
  cube_direction = cube_face_direction(face, corner);
  gl_Position = vec4(corner, 0.0, 1.0);
}
