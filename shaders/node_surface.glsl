// What pixels know of a ground of nodes: its slopes from the vertices, and the layers that those can't hold from themselves.
// node_map.glsl or node_no_map.glsl stands before it.
#include "ground_map.glsl"
#include "anchored_layers.glsl"
#include "node_inputs.glsl"

// As much of a layer as the vertices hold.
float held_of_layer(float frequency) {
  return mix(layer_weight(frequency, node_held.x), layer_weight(frequency, 2.0 * node_held.x), node_held.y);
}

// How strongly layers act, for unseen_slopes, which takes all of them for as steep as those that are no ridges of ranges.
// Those ridges are the ones that a ridged ground has anyway, so that both rise together; else one knows nothing of the other.
float layer_rise(GroundAt ground) {
  bool is_ridged = terrain_ridged != 0;
  float rise = node_height.y, ridges = node_height.z;
  float steeper = layer_slope_square(true, terrain_ridge_sharpness) / layer_slope_square(is_ridged, terrain_ridge_sharpness);
  float together = is_ridged ? 2.0 * rise * ridges : 0.0;
  return sqrt(rise * rise + together + steeper * ridges * ridges) * amplitude_sum(terrain_persistence, terrain_octaves);
}

// Craters that the vertices can't hold and a pixel can, added to the mean of all layers and its gradient. They are told
// from the direction itself: where pixels come near to what a float knows of it, the vertices hold them all.
void add_finer_craters(vec3 up, float footprint, inout float mean, inout vec3 gradient) {
  if (terrain_craters <= 0.0 || terrain_height <= 0.0) return;
  float dug = 0.0, frequency = terrain_crater_frequency;
  vec3 slope = vec3(0.0);
  for (int i = 0; i < terrain_crater_sizes; ++i) {
    float weight = crater_weight(frequency, footprint);
    if (weight <= 0.0) break;  // and so is that of all smaller ones
    float shown = terrain_craters * max(weight - held_of_layer(crater_detail * frequency), 0.0);
    if (shown > 0.0) add_craters_of_size(up, i, frequency, uint(planet_seed), shown, dug, slope);
    frequency *= crater_step;
  }
  mean += dug / terrain_height;
  gradient += slope / terrain_height;
}

// The ground at the pixel as fine as it can show it. up: unit; footprint: rad.
GroundAt node_ground(vec3 up, vec3 from_anchor, float footprint) {
  GroundAt ground;
  ground.openness = node_slope.w;
  ground.height = node_height.x;
  vec3 gradient = node_slope.xyz, ridge_gradient = vec3(0.0);
  float amplitude = node_layers.y, rise = node_height.y, ridges = node_height.z, ridge = 0.0;
  bool is_ridged = terrain_ridged != 0;
  for (int i = int(node_layers.x); i < int(ground_map_scale.z); ++i) {
    float frequency = layer_place[i].w;
    float weight = layer_weight(frequency, footprint);
    if (weight <= 0.0) break;  // and so is that of all finer layers
    Noise n = layer_noise(i, from_anchor);
    float shown = amplitude * max(weight - held_of_layer(frequency), 0.0);
    ground.height += shown * rise * (layer_value(n.value, is_ridged, terrain_ridge_sharpness) - layer_mean(is_ridged));
    gradient += (shown * frequency * rise * layer_slope(n.value, is_ridged, terrain_ridge_sharpness)) * n.gradient;
    if (ridges > 0.0 && i >= terrain_range_layer) {
      ridge += shown * (layer_value(n.value, true, terrain_ridge_sharpness) - layer_mean(true));
      ridge_gradient += (shown * frequency * layer_slope(n.value, true, terrain_ridge_sharpness)) * n.gradient;
    }
    amplitude *= terrain_persistence;
  }
  float of_ridges = amplitude_sum(terrain_persistence, terrain_octaves) - amplitude_sum(terrain_persistence, terrain_range_layer);
  RidgesAdded added = ridges_added(ridge, of_ridges);
  ground.height += ridges * added.height;
  gradient += (ridges * added.slope) * ridge_gradient;
  float dug = 0.0;
  vec3 dug_gradient = vec3(0.0);
  add_finer_craters(up, footprint, dug, dug_gradient);
  float rise_of_mean = rise * amplitude_sum(terrain_persistence, terrain_octaves);
  ground.height += rise_of_mean * dug;
  gradient += rise_of_mean * dug_gradient;
  ground.gradient = gradient - dot(gradient, up) * up;
  add_finer_map(ground, up, footprint);
  return ground;
}
