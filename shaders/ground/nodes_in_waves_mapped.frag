// The same with continents of a map.
#include "ground_surface.glsl"
#include "node_map.glsl"
#include "node_surface.glsl"
#include "ground_in_waves.glsl"

void main() {
  vec3 place = surface_from_eye;
  GroundAt ground = node_ground(place, normalize(place));
  emit_ground(place, ground, layer_rise(ground), 0.0);
}
