// The height of the ground where a map tells its continents: layers of noise add what is finer than its texels.
#include "lib/height_map.glsl"
#include "lib/heights.glsl"

// The first layer that a map with such texels (rad) can't hold: its cells are narrower than three of them.
int first_layer_beyond(float texel, Terrain t) {
  int first = 0;
  for (float frequency = t.frequency; first < t.octaves && 3.0 * frequency * texel <= 1.0; frequency *= t.lacunarity) ++first;
  return first;
}

// How much a unit of the mean of all layers adds, as a part of the highest: what it does where layers alone reach the
// height `part`, but no less than on low ground, and never infinitely steep. p: as in height_power, at least 1 here.
float mapped_rise(float part, float p) {
  float q = max(p, 1.0);
  return q * pow(max(part, 0.0) + 0.02, 1.0 - 1.0 / q);
}

// The derivative of mapped_rise by part.
float mapped_rise_slope(float part, float p) {
  float q = max(p, 1.0);
  return (q - 1.0) * pow(max(part, 0.0) + 0.02, -1.0 / q);
}

// How high ground stands where layers add so much to their mean and a map tells so much (0..1).
Relief mapped_relief_of(Terrain t, float added, float map) {
  float rise = mapped_rise(map, t.power);
  float part = map + rise * added;
  bool held = part <= 0.0 || part >= 1.0;
  Relief r;
  r.value = t.height * clamp(part, 0.0, 1.0);
  r.by_mean = held ? 0.0 : t.height * rise;
  r.by_shape = held ? 0.0 : t.height * (1.0 + mapped_rise_slope(map, t.power) * added);
  return r;
}

// The ground at a direction (unit), without what samples a footprint (rad) apart can't show. Ranges are the map's own.
Height mapped_height_at(vec3 direction, Terrain t, highp sampler2D map, float footprint) {
  MapHeight shape = map_height_at(map, direction, footprint);
  int first = first_layer_beyond(map_texel(map), t);
  float mean = layer_mean(t.ridged);
  float frequency = t.frequency;
  float relief = 0.0;
  vec3 gradient = vec3(0.0);
  OctaveSum sum = no_octaves();
  for (int i = 0; i < t.octaves; ++i) {
    float shown = i < first ? 0.0 : layer_weight(frequency, footprint);
    float value = 0.0;  // over its mean, which the map holds
    if (shown > 0.0) {
      Noise n = height_noise(direction, t, i, frequency);
      value = shown * (layer_value(n.value, t.ridged, t.sharpness) - mean);
      gradient += sum.amplitude * shown * frequency * layer_slope(n.value, t.ridged, t.sharpness) * n.gradient;
      relief += sum.amplitude * frequency * value;
    }
    add_octave(sum, value, t.persistence);
    frequency *= t.lacunarity;
  }
  float total = sum.total > 0.0 ? sum.total : 1.0;
  float added = sum.sum / total;
  if (t.craters.depth > 0.0 && t.height > 0.0) {
    float dug = 0.0;
    vec3 slope = vec3(0.0);
    add_craters(direction, t.craters, footprint, dug, slope);
    added += dug / t.height;
    gradient += (total / t.height) * slope;
    relief += total / t.height * dug * t.craters.frequency;
  }
  Height ground;
  ground.mean = added;
  ground.shape = shape.value;
  ground.iced = false;
  Relief relief_here = mapped_relief_of(t, ground.mean, ground.shape);
  float rise = relief_here.by_mean / total;
  ground.value = relief_here.value;
  ground.shape_gradient = relief_here.by_shape * shape.gradient;
  ground.gradient = ground.shape_gradient + rise * gradient;
  ground.relief = t.height * shape.relief + relief * rise;
  ground.openness = openness_of(ground.relief);
  lay_ice(ground, direction, t.ice, footprint);
  return ground;
}
