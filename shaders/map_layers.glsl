// The layers that pixels add to the map of the ground.
#include "fine_layers.glsl"

float held_of_layer(float frequency) { return layer_weight(frequency, ground_map_scale.x); }

// As fine_layers; they enter where the map's texels grow larger than pixels.
FineLayers layers_beside_map(vec3 from_anchor, float footprint) {
  float enters = 1.0 - smoothstep(0.67, 1.0, fineness.y * footprint / ground_map_scale.x);
  return fine_layers(from_anchor, footprint, int(ground_map_scale.y), enters);
}
