// The ground from so near that pixels are finer than its map: further layers of noise at every pixel.
#include "anchored_layers.glsl"

// What the layers finer than the map add.
struct FineLayers {
  vec3 gradient;  // to that of the mean of all layers
  float grain;    // to the colour, about -1..1: what is flat shows them, too
};

// from_anchor: of the place; footprint: of a pixel there, rad.
FineLayers fine_layers(vec3 from_anchor, float footprint) {
  float texel = ground_map_scale.x;
  float enters = 1.0 - smoothstep(0.67, 1.0, fineness.y * footprint / texel);
  FineLayers fine;
  fine.gradient = vec3(0.0);
  fine.grain = 0.0;
  float strength = 0.4;
  int first = int(ground_map_scale.y), end = int(ground_map_scale.z);
  float amplitude = enters * layer_anchor.w;
  for (int i = first; i < end; ++i) {
    float frequency = layer_place[i].w;
    float weight = layer_weight(frequency, footprint);
    if (weight <= 0.0) break;  // and so is that of all finer layers
    Noise n = layer_noise(i, from_anchor);
    float slope = layer_slope(n.value, terrain_ridged != 0, terrain_ridge_sharpness);
    float shown = max(weight - layer_weight(frequency, texel), 0.0);
    fine.gradient += amplitude * shown * frequency * slope * n.gradient;
    fine.grain += enters * strength * shown * n.value;
    strength *= 0.8;
    amplitude *= terrain_persistence;
  }
  return fine;
}

// The ground with the layers that the map can't hold. up: unit, of the place.
GroundAt refined(GroundAt ground, FineLayers fine, vec3 up) {
  vec3 gradient = fine.gradient * map_rise(ground);
  ground.gradient += gradient - dot(gradient, up) * up;
  return ground;
}
