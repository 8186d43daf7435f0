// The ground of nodes.
#include "ground_surface.glsl"
#include "ground_in_still_water.glsl"
#include "node_no_map.glsl"
#include "node_surface.glsl"

void main() {
  vec3 place = surface_from_eye;
  GroundAt ground = node_ground(place, normalize(place));
  emit_ground(place, ground, layer_rise(ground), 0.0);
}
