// Land on the water's mesh from so near that pixels are finer than the map of the ground.
#include "shore_map.glsl"
#include "fine_layers.glsl"

void refine_land(inout GroundAt land, inout float grain, vec3 up, float depth) {
  if (depth > 0.0) return;
  FineLayers fine = fine_layers(direction_from_anchor(surface_from_eye), pixel_footprint(up, surface_from_eye, 0.12));
  land = refined(land, fine, up);
  grain = fine.grain;
}
