// Layers of the ground's noise at a pixel, told from a place near the eye.
#include "ground_map.glsl"
#include "layer_block.glsl"

// The direction of a place less the anchor's, from the place's offset to the eye: no large numbers are subtracted.
vec3 direction_from_anchor(vec3 offset) {
  float eye_radius = 1.0 + eye_high.w;
  vec3 anchor = layer_anchor.xyz;
  float radius2 = eye_radius * eye_radius + 2.0 * eye_radius * dot(anchor, offset) + dot(offset, offset);
  float radius = sqrt(max(radius2, 1.0e-12));
  float climb = (2.0 * eye_radius * dot(anchor, offset) + dot(offset, offset)) / (radius + eye_radius);
  return (offset - anchor * climb) / radius;
}

// Of layer i, at a direction less the anchor's.
Noise layer_noise(int i, vec3 from_anchor) {
  vec3 q = layer_place[i].xyz + layer_place[i].w * from_anchor;
  return simplex_noise(layer_cell[i].xyz, q, layer_seed(i, uint(planet_seed)));
}
