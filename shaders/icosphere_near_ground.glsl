// The icosphere's ground so near that pixels are finer than its map.
#include "ground_surface.glsl"
#include "fine_layers.glsl"

void main() {
  vec3 up = normalize(surface_position());
  vec3 from_anchor = direction_from_anchor(surface_from_eye);
  // On a steep slope that faces the eye a pixel covers less than on level ground.
  vec3 right = dFdx(from_anchor), above = dFdy(from_anchor);
  float level = pixel_footprint(up, surface_from_eye, 0.12);
  float facing = fineness.x * sqrt(max(dot(right, right), dot(above, above)));
  FineLayers fine = fine_layers(from_anchor, min(level, facing));
  GroundAt ground = ground_at(textureLod(ground_map, up, levels.z), up);
  emit_ground(surface_from_eye, refined(ground, fine, up), map_rise(ground), fine.grain);
}
