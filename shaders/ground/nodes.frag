// The ground of nodes.
#include "ground_surface.glsl"
#include "node_no_map.glsl"
#include "node_surface.glsl"

void main() {
  vec3 up = normalize(surface_position());
  vec3 from_anchor = direction_from_anchor(surface_from_eye);
  GroundAt ground = node_ground(up, from_anchor, pixel_footprint(up, surface_from_eye, 0.12));
  emit_ground(ground, layer_rise(ground), 0.0);
}
