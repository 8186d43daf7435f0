// What pixels know of a ground of nodes: its slopes from the vertices, and the layers that those can't hold from themselves.
// node_map.glsl or node_no_map.glsl stands before it.
#include "ground_map.glsl"
#include "anchored_layers.glsl"
#include "node_inputs.glsl"

// As much of a layer as the vertices hold.
float held_of_layer(float frequency) {
  return mix(layer_weight(frequency, node_held.x), layer_weight(frequency, 2.0 * node_held.x), node_held.y);
}

// The sums of amplitudes that means are of: of all layers, and of the ridges of ranges.
float all_layers() { return max(amplitude_sum(terrain_persistence, terrain_octaves), 1.0e-6); }
float all_ridges() { return max(all_layers() - amplitude_sum(terrain_persistence, terrain_range_layer), 1.0e-6); }

// How steep ground is made of so many layers and ridges: each is as steep as any other, whatever the width of its cells, of
// which heights of real ground are about in proportion.
float steepness(Relief r, float layers, float ridges) {
  float of_layers = r.by_mean / all_layers(), of_ridges = r.by_shape / all_ridges();
  return sqrt(layers * of_layers * of_layers + ridges * of_ridges * of_ridges);
}

// How strongly layers act, for unseen_slopes, which takes all of them for as steep as those that are no ridges of ranges.
// Those ridges are the ones that a ridged ground has anyway, so that both rise together; else one knows nothing of the other.
float layer_rise(GroundAt ground) {
  bool is_ridged = terrain_ridged != 0;
  Relief held = node_relief(node_height.y, node_height.z);
  float rise = held.by_mean / all_layers(), ridges = node_has_ranges ? held.by_shape / all_ridges() : 0.0;
  float steeper = layer_slope_square(true, terrain_ridge_sharpness) / layer_slope_square(is_ridged, terrain_ridge_sharpness);
  float together = is_ridged ? 2.0 * rise * ridges : 0.0;
  return (1.0 - node_height.w) * sqrt(rise * rise + together + steeper * ridges * ridges) * all_layers();
}

// What pixels add to a mean, and to its gradient.
struct Added {
  float value;
  vec3 gradient;
};

// Craters that the vertices can't hold and a pixel can, added to the mean of all layers. They are told from the direction
// itself: where pixels come near to what a float knows of it, the vertices hold them all.
void add_finer_craters(inout Added mean, inout float relief, vec3 up, float footprint) {
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
  mean.value += dug / terrain_height;
  mean.gradient += slope / terrain_height;
  relief += all_layers() / terrain_height * dug * terrain_crater_frequency;
}

// Layers that the vertices can't hold and a pixel can, added to the mean of all, to that of ridges and to the relief.
void add_finer_layers(inout Added mean, inout Added ridges, inout float relief, vec3 from_anchor, float footprint) {
  float amplitude = node_layers.y;
  bool is_ridged = terrain_ridged != 0, has_ranges = node_has_ranges && terrain_ranges > 0.0;
  for (int i = int(node_layers.x); i < int(ground_map_scale.z); ++i) {
    float frequency = layer_place[i].w;
    float weight = layer_weight(frequency, footprint);
    if (weight <= 0.0) break;  // and so is that of all finer layers
    Noise n = layer_noise(i, from_anchor);
    float shown = amplitude * max(weight - held_of_layer(frequency), 0.0);
    float of_mean = shown / all_layers(), of_ridges = shown / all_ridges();
    float added = layer_value(n.value, is_ridged, terrain_ridge_sharpness) - layer_mean(is_ridged);
    mean.value += of_mean * added;
    if (i > 0) relief += shown * frequency * added;
    mean.gradient += (of_mean * frequency * layer_slope(n.value, is_ridged, terrain_ridge_sharpness)) * n.gradient;
    if (has_ranges && i >= terrain_range_layer) {
      ridges.value += of_ridges * (layer_value(n.value, true, terrain_ridge_sharpness) - layer_mean(true));
      ridges.gradient += (of_ridges * frequency * layer_slope(n.value, true, terrain_ridge_sharpness)) * n.gradient;
    }
    amplitude *= terrain_persistence;
  }
}

// The ground at the pixel as fine as it can show it: vertices tell the means of what they hold of it, the pixel adds what
// they can't. Ice is where the vertices have it. up: unit; footprint: rad.
GroundAt node_ground(vec3 up, vec3 from_anchor, float footprint) {
  Added mean = Added(0.0, vec3(0.0)), shape = mean;
  float relief = 0.0;  // of a ground as high as the sum of all layers
  add_finer_layers(mean, shape, relief, from_anchor, footprint);
  add_finer_craters(mean, relief, up, footprint);
  add_finer_map(shape.value, shape.gradient, up, footprint);
  Relief held = node_relief(node_height.y, node_height.z);
  Relief all = node_relief(node_height.y + mean.value, max(node_height.z + shape.value, 0.0));
  // What of the vertices' slope is which mean's is not told: both as far as layers of each are held.
  float layers = node_layers.x + 1.0, ridges = node_has_ranges ? max(node_layers.x - float(terrain_range_layer), 0.0) : 0.0;
  float before = steepness(held, layers, ridges);
  float steeper = before > 0.0 ? min(steepness(all, layers, ridges) / before, 4.0) : 1.0;
  GroundAt ground;
  float rise = all.by_mean / all_layers() + (node_has_ranges ? all.by_shape / all_ridges() : 0.0);
  ground.openness = openness_of(steeper * node_slope.w + (1.0 - node_height.w) * rise * relief);
  ground.height = mix(all.value - node_sea_level, node_height.x, node_height.w);
  vec3 finer = all.by_mean * mean.gradient + all.by_shape * shape.gradient;
  vec3 gradient = steeper * node_slope.xyz + (1.0 - node_height.w) * finer;
  ground.gradient = gradient - dot(gradient, up) * up;
  return ground;
}
