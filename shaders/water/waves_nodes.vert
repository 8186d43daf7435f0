#include "node_vertex.glsl"
#include "node_waves.glsl"

out vec3 still_from_eye;
out vec3 surface_from_eye;

void main() {
  NodeVertex v = node_vertex();
  still_from_eye = node_sea.xyz + sea.x * v.flat_place;
  // As far apart as vertices are where this one is, whatever the node's level.
  float spacing = node_around.w * (1.0 + node_held.y);
  SeaAt at = sea_waves(still_from_eye, spacing, -node_height.x, node_slope.xyz);
  surface_from_eye = still_from_eye + wave_offset(at.up, at.frame, at.sum);
  float away = length(surface_from_eye);
  surface_from_eye += away * v.skirt + min(levels.y * away, levels.w) * v.up;
  gl_Position = clip_at(surface_from_eye);
}
