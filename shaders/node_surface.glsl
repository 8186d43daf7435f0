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

// How much a layer lifts the ground for each unit of its value, and how much one does that is a ridge of ranges.
vec2 rises_of(Relief r) { return vec2(r.by_mean / all_layers(), node_has_ranges ? r.by_shape / all_ridges() : 0.0); }

// How steep ground is made of so many layers and ridges: each is as steep as any other, whatever the width of its cells, of
// which heights of real ground are about in proportion.
float steepness(vec2 rises, vec2 held) { return sqrt(dot(held, rises * rises)); }

// How strongly layers act, for unseen_slopes, which takes all of them for as steep as those that are no ridges of ranges.
// Those ridges are the ones that a ridged ground has anyway, so that both rise together; else one knows nothing of the other.
float layer_rise(GroundAt ground) {
  bool is_ridged = terrain_ridged != 0;
  vec2 rises = rises_of(node_relief(node_height.y, node_height.z));
  float steeper = layer_slope_square(true, terrain_ridge_sharpness) / layer_slope_square(is_ridged, terrain_ridge_sharpness);
  float together = is_ridged ? 2.0 * rises.x * rises.y : 0.0;
  float square = rises.x * rises.x + together + steeper * rises.y * rises.y;
  return (1.0 - node_height.w) * sqrt(square) * all_layers();
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
  float amplitude = node_layers.y, of_mean = 1.0 / all_layers(), of_ridges = 1.0 / all_ridges();
  bool is_ridged = terrain_ridged != 0, has_ranges = node_has_ranges && terrain_ranges > 0.0;
  for (int i = int(node_layers.x); i < int(ground_map_scale.z); ++i) {
    float frequency = layer_place[i].w;
    float weight = layer_weight(frequency, footprint);
    if (weight <= 0.0) break;  // and so is that of all finer layers
    float shown = amplitude * max(weight - held_of_layer(frequency), 0.0);
    amplitude *= terrain_persistence;
    if (shown <= 0.0) continue;
    Noise n = layer_noise(i, from_anchor);
    float added = shown * (layer_value(n.value, is_ridged, terrain_ridge_sharpness) - layer_mean(is_ridged));
    mean.value += of_mean * added;
    mean.gradient += (of_mean * shown * frequency * layer_slope(n.value, is_ridged, terrain_ridge_sharpness)) * n.gradient;
    if (i > 0) relief += frequency * added;
    if (has_ranges && i >= terrain_range_layer) {
      ridges.value += of_ridges * shown * (layer_value(n.value, true, terrain_ridge_sharpness) - layer_mean(true));
      ridges.gradient += (of_ridges * shown * frequency * layer_slope(n.value, true, terrain_ridge_sharpness)) * n.gradient;
    }
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
  vec2 rises_held = rises_of(node_relief(node_height.y, node_height.z));
  Relief all = node_relief(node_height.y + mean.value, max(node_height.z + shape.value, 0.0));
  vec2 rises = rises_of(all);
  // What of the vertices' slope is which mean's is not told: both as far as layers of each are held.
  vec2 held = vec2(node_layers.x + 1.0, max(node_layers.x - float(terrain_range_layer), 0.0));
  float before = steepness(rises_held, held);
  float steeper = before > 0.0 ? min(steepness(rises, held) / before, 4.0) : 1.0;
  GroundAt ground;
  ground.openness = openness_of(steeper * node_slope.w + (1.0 - node_height.w) * (rises.x + rises.y) * relief);
  ground.height = mix(all.value - node_sea_level, node_height.x, node_height.w);
  vec3 finer = all.by_mean * mean.gradient + all.by_shape * shape.gradient;
  vec3 gradient = steeper * node_slope.xyz + (1.0 - node_height.w) * finer;
  ground.gradient = gradient - dot(gradient, up) * up;
  return ground;
}
