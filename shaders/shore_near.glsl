// Land on the water's mesh from so near that pixels are finer than the map of the ground.
#include "water_surface.glsl"
#include "fine_layers.glsl"

void emit_land(vec3 up) {
  FineLayers fine = fine_layers(direction_from_anchor(surface_from_eye), pixel_footprint(up, surface_from_eye, 0.12));
  emit_ground(refined(ground_at(textureLod(ground_map, up, levels.z), up), fine, up), fine.grain);
}
