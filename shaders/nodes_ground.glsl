// The ground of nodes; node_map.glsl or node_no_map.glsl stands before it.
#include "ground_surface.glsl"
#include "node_surface.glsl"

void main() {
  vec3 place = surface_from_eye;
  GroundAt ground = node_ground(place, ray_to(place));
  emit_ground(place, ground, layer_rise(ground), 0.0);
}
