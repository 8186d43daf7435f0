#include "frame_block.glsl"

layout(location = 0) in vec3 position;

out vec3 surface_from_eye;

void main() {
  surface_from_eye = from_eye(position);
  gl_Position = clip_from_eye * vec4(surface_from_eye, 1.0);
}
