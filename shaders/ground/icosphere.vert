#include "frame_block.glsl"

layout(location = 0) in vec3 position;

out vec3 surface_from_eye;

void main() {
  surface_from_eye = from_eye(position);
  gl_Position = clip_at(surface_from_eye);
}
