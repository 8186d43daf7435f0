#include "frame_block.glsl"
#include "wave_block.glsl"

uniform samplerCube ground_map;

layout(location = 0) in vec3 direction;

out vec3 still_direction;
out vec3 surface_from_eye;

void main() {
  still_direction = direction;
  Frame frame = frame_at(direction);
  WaveSum sum = waves_at(direction, frame, ripple.y, textureLod(ground_map, direction, 0.0));
  surface_from_eye = from_eye(direction * (sea.x + levels.y) + wave_offset(direction, frame, sum));
  gl_Position = clip_at(surface_from_eye);
}
