#include "frame_block.glsl"

uniform float shell;  // radius

layout(location = 0) in vec3 direction;

out vec3 surface_from_eye;

void main() {
  surface_from_eye = from_eye(direction * shell);
  gl_Position = clip_at(surface_from_eye);
}
