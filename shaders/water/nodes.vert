#include "node_vertex.glsl"

out vec3 surface_from_eye;
out vec4 node_slope;
out vec3 node_height;
out vec2 node_held;
flat out vec2 node_layers;

void main() {
  NodeVertex v = node_vertex();
  surface_from_eye = node_sea.xyz + sea.x * v.flat_place;
  float away = length(surface_from_eye);
  surface_from_eye += away * v.skirt + min(levels.y * away, levels.w) * v.up;
  node_slope = node_slope_at(v.part);
  node_height = vec3(node_sea.w + v.height, node_rise_at(v.part));
  node_held = vec2(node_along.w / float(node_cells), v.part);
  node_layers = node_around.yz;
  gl_Position = clip_at(surface_from_eye);
}
