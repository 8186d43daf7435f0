#include "node_vertex.glsl"

out vec3 surface_from_eye;

void main() {
  NodeVertex v = node_vertex();
  surface_from_eye = node_sea.xyz + sea.x * v.flat_place;
  float away = length(surface_from_eye);
  surface_from_eye += away * v.skirt + min(levels.y * away, levels.w) * v.up;
  gl_Position = clip_at(surface_from_eye);
}
