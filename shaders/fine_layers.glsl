// The ground from so near that pixels are finer than its map: further layers of noise at every pixel.
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

// As much of a layer as is there without pixels, 0..1; falls with the frequency.
float held_of_layer(float frequency);

// What finer layers add to those.
struct FineLayers {
  vec3 gradient;  // to that of the mean of all layers
  float value;    // to that mean itself
  float grain;    // to the colour, about -1..1: what is flat shows them, too
};

// from_anchor: of the place; footprint: of a pixel there, rad; first: of the layers, all before are held; part: how strong
// they are, of what layer_anchor says.
FineLayers fine_layers(vec3 from_anchor, float footprint, int first, float part) {
  uint seed = uint(planet_seed);
  FineLayers fine;
  fine.gradient = vec3(0.0);
  fine.value = 0.0;
  fine.grain = 0.0;
  float strength = 0.4;
  int end = int(ground_map_scale.z);
  float amplitude = part * layer_anchor.w;
  for (int i = first; i < end; ++i) {
    float frequency = layer_place[i].w;
    float weight = layer_weight(frequency, footprint);
    if (weight <= 0.0) break;  // and so is that of all finer layers
    vec3 q = layer_place[i].xyz + frequency * from_anchor;
    Noise n = simplex_noise(layer_cell[i].xyz, q, layer_seed(i, seed));
    float slope = layer_slope(n.value, terrain_ridged != 0, terrain_ridge_sharpness);
    float shown = max(weight - held_of_layer(frequency), 0.0);
    fine.gradient += amplitude * shown * frequency * slope * n.gradient;
    float value = layer_value(n.value, terrain_ridged != 0, terrain_ridge_sharpness);
    fine.value += amplitude * shown * (value - layer_mean(terrain_ridged != 0));
    fine.grain += part * strength * shown * n.value;
    strength *= 0.8;
    amplitude *= terrain_persistence;
  }
  return fine;
}

// The ground with the layers that the map can't hold. up: unit, of the place.
GroundAt refined(GroundAt ground, FineLayers fine, vec3 up) {
  float slope = height_power_slope_at(ground.height + sea.x - 1.0, terrain_height, terrain_power);
  vec3 gradient = fine.gradient * slope;
  ground.gradient += gradient - dot(gradient, up) * up;
  return ground;
}
