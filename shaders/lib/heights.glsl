// The height of the ground: layers of noise, shaped (Sandahl 2022, equations 1 to 6).
#include "lib/craters.glsl"
#include "lib/ice.glsl"
#include "lib/noise.glsl"

// Mountain ranges on high ground: where the mean of all layers is high, the cube of the mean of ridges of the same noise
// rises from it. So valleys are wide and smooth, and crests narrow and rough, as erosion leaves them. A part of them stands on
// low ground as well, so that plains and shores have hills, dunes and stones.
struct Ranges {
  float part;  // of the height that they may take, 0..1; 0: there are none
  int first;   // layer whose ridges are the broadest
  float low;   // part of them that stands on low ground, 0..1
};

struct Terrain {
  float height;       // H, planet radii
  float frequency;    // of the coarsest layer, cells per radius
  int octaves;        // 0..32
  float persistence;  // 0..1.5
  float lacunarity;   // 1..4
  float power;        // p, 0..16
  bool ridged;
  float sharpness;  // k of the smooth absolute value, 0..1000
  uint seed;
  Ranges ranges;
  Craters craters;  // dug into the sum of layers
  Ice ice;          // lies over what is lower
#ifdef TERRELLA_HOST
  sampler2D map;  // in C++, which asks one function for heights with and without a map; none: the layers are all there is
#endif
};

// A height and how it changes over the unit sphere (radii per radian along each axis, not yet made tangential).
struct Height {
  float value;
  vec3 gradient;
  vec3 shape_gradient;  // what of it comes of the shape
  float relief;    // what openness is told of (openness_of)
  float openness;  // 0..1: below a half in hollows, above it on crests
  // What it is made of, under the ice (relief_of): the mean of all layers, and that of the ridges of ranges. Where a map
  // tells continents (mapped_relief_of), what the layers finer than it add to that mean, and what the map tells.
  float mean, shape;
  bool iced;  // ice lies there, whose height no mean tells
};

// x tanh(k x): |x| without its edge (5). k >= 0; total, where the printed form overflows for k|x| > 88.
float smooth_abs(float x, float k) {
  float u = 2.0 * k * abs(x);
  if (u < 0.7) return abs(x) * tanh(0.5 * u);
  float e = exp(-u);
  return abs(x) * (1.0 - e) / (1.0 + e);
}

// The derivative of smooth_abs by x, -1.2..1.2.
float smooth_abs_slope(float x, float k) {
  float u = min(k * abs(x), 40.0);
  float e = exp(-2.0 * u);
  float t = u < 0.35 ? tanh(u) : (1.0 - e) / (1.0 + e);
  float slope = t + u * (1.0 - t * t);
  return x < 0.0 ? -slope : slope;
}

// H h^p (6), with h held to 0..1 (noise passes its ends by a hundredth), 0^0 = 1 and 0^p = 0.
float height_power(float h, float height, float p) {
  float x = clamp(h, 0.0, 1.0);
  if (p == 0.0) return height;
  return x > 0.0 ? height * pow(x, p) : 0.0;
}

// The derivative of height_power by h; 0 where h is held, and finite at 0.
float height_power_slope(float h, float height, float p) {
  if (h <= 0.0 || h >= 1.0) return 0.0;
  return height * p * pow(max(h, 1.0e-3), p - 1.0);
}

// The same where the power has already been taken: at a height over the sphere. height: of the highest, p: as above.
float height_power_slope_at(float value, float height, float p) {
  return height_power_slope(pow(clamp(value / max(height, 1.0e-9), 1.0e-6, 0.999), 1.0 / max(p, 0.05)), height, p);
}

// One layer from a noise value: (1 + n)/2 as in (1), or the ridge 1 - |n| as in (4), its edge rounded as in (5): to nothing
// that single precision could tell from |n| where the sharpness is 1e30.
float layer_value(float n, bool ridged, float sharpness) {
  return ridged ? 1.0 - smooth_abs(n, sharpness) : 0.5 + 0.5 * n;
}

float layer_slope(float n, bool ridged, float sharpness) {
  return ridged ? -smooth_abs_slope(n, sharpness) : 0.5;
}

// The mean square of a layer's slope, as a part of that of its noise. Ridges are steeper by at most a twentieth and less
// steep by at most a tenth (tests/laws/heights_test.cpp).
float layer_slope_square(bool ridged, float sharpness) {
  return ridged ? 1.0 / (1.0 + 2.1 * pow(max(sharpness, 1.0e-3), -2.2)) : 0.25;
}

// What a layer too fine to be shown leaves behind: its mean. 0.31 is E|n| of the noise (tests/laws/noise_test.cpp).
float layer_mean(bool ridged) {
  return ridged ? 0.69 : 0.5;
}

// How open a place is whose layers, all but the coarsest, lift it by relief: the sum of their heights, each divided by the
// width of its hills. Stands for the part of the sky that is seen, without looking around.
float openness_of(float relief) {
  float x = clamp(10.0 * relief, -1.0e6, 1.0e6);
  return 0.5 + 0.5 * x / sqrt(1.0 + x * x);
}

// How much of the ranges stands where the mean of all layers is h: low (0..1) of them on low ground, all on high.
float range_cover(float h, float low) { return mix(low, 1.0, smoothstep(0.5, 0.75, h)); }

// The derivative of range_cover by h.
float range_cover_slope(float h, float low) {
  float t = clamp(4.0 * (h - 0.5), 0.0, 1.0);
  return 24.0 * (1.0 - low) * t * (1.0 - t);
}

// The ridges of the ranges so far.
struct RidgeSum {
  float total;    // of the amplitudes
  float sum;
  vec3 gradient;  // of the sum
};

RidgeSum no_ridges() {
  RidgeSum r;
  r.total = 0.0;
  r.sum = 0.0;
  r.gradient = vec3(0.0);
  return r;
}

// n: the noise of a layer; shown: part of it that is not left at its mean.
void add_ridges(inout RidgeSum r, Noise n, float amplitude, float frequency, float sharpness, float shown) {
  float value = mix(layer_mean(true), layer_value(n.value, true, sharpness), shown);
  r.sum += amplitude * value;
  r.gradient += amplitude * shown * frequency * layer_slope(n.value, true, sharpness) * n.gradient;
  r.total += amplitude;
}

// Ridges fainter than this, of the strength of the coarsest layer, are none: nothing could be divided by what single
// precision holds of their sum.
const float faintest_ridges = 1.0e-30;

float mean_of_ridges(RidgeSum r) { return r.total > faintest_ridges ? max(r.sum / r.total, 0.0) : 0.0; }

// How high ground stands that is made of two means, radii, and how that changes with each.
struct Relief {
  float value, by_mean, by_shape;
};

// mean: of all layers; ridges: of those of ranges.
Relief relief_of(Terrain t, float mean, float ridges) {
  Relief r;
  r.value = 0.0;
  r.by_mean = 0.0;
  r.by_shape = 0.0;
  if (t.octaves == 0) return r;
  float smooth_height = (1.0 - t.ranges.part) * t.height, ranges = t.ranges.part * t.height;
  float cover = range_cover(mean, t.ranges.low), square = ridges * ridges;
  r.value = height_power(mean, smooth_height, t.power) + ranges * cover * square * ridges;
  r.by_mean = height_power_slope(mean, smooth_height, t.power) +
              ranges * range_cover_slope(mean, t.ranges.low) * square * ridges;
  r.by_shape = 3.0 * ranges * cover * square;
  return r;
}

// Ice lies open: to three fifths.
const float relief_of_ice = 0.0204;

// Ice lies over what is lower.
void lay_ice(inout Height ground, vec3 direction, Ice ice, float footprint) {
  if (!raised_to_ice(ground.value, direction, ice, footprint)) return;
  ground.gradient = vec3(0.0);
  ground.shape_gradient = vec3(0.0);
  ground.relief = relief_of_ice;
  ground.openness = openness_of(relief_of_ice);
  ground.iced = true;
}

// What the ground at a place is made of, as far as samples so far apart can show it.
struct HeightParts {
  float footprint;   // rad
  OctaveSum layers;
  vec3 gradient;     // of the sum of all layers
  float relief;      // as openness_of takes it, of a ground as high as that sum
  RidgeSum ridges;
  float dug;         // by craters, radii
  vec3 dug_gradient;
};

HeightParts no_height(float footprint) {
  HeightParts p;
  p.footprint = footprint;
  p.layers = no_octaves();
  p.gradient = vec3(0.0);
  p.relief = 0.0;
  p.ridges = no_ridges();
  p.dug = 0.0;
  p.dug_gradient = vec3(0.0);
  return p;
}

// The noise of layer i at a direction (unit).
Noise height_noise(vec3 direction, Terrain t, int i, float frequency) {
  return simplex_noise(ivec3(0), direction * frequency + layer_offset(i, t.seed), layer_seed(i, t.seed));
}

// n: height_noise, or no_noise where the footprint leaves nothing of layer i.
void add_height_layer(inout HeightParts p, Terrain t, int i, float frequency, Noise n) {
  float shown = layer_weight(frequency, p.footprint);
  float mean = layer_mean(t.ridged);
  float value = mean;
  if (shown > 0.0) {
    value = mix(mean, layer_value(n.value, t.ridged, t.sharpness), shown);
    p.gradient += p.layers.amplitude * shown * frequency * layer_slope(n.value, t.ridged, t.sharpness) * n.gradient;
  }
  bool is_ridge = t.ranges.part > 0.0 && i >= t.ranges.first;
  if (is_ridge) add_ridges(p.ridges, n, p.layers.amplitude, frequency, t.sharpness, shown);
  if (i > 0) p.relief += p.layers.amplitude * frequency * (value - mean);
  add_octave(p.layers, value, t.persistence);
}

// direction: unit.
Height height_of(HeightParts p, vec3 direction, Terrain t) {
  float of_dug = t.height > 0.0 ? 1.0 / t.height : 0.0;
  float total = p.layers.total;
  Height ground;
  ground.mean = octave_mean(p.layers) + of_dug * p.dug;
  ground.shape = mean_of_ridges(p.ridges);
  ground.iced = false;
  Relief relief_here = relief_of(t, ground.mean, ground.shape);
  float rise = total > 0.0 ? relief_here.by_mean / total : 0.0;
  float rise_of_ridges = p.ridges.total > faintest_ridges ? relief_here.by_shape / p.ridges.total : 0.0;
  vec3 gradient = p.gradient + (total * of_dug) * p.dug_gradient;
  float relief = p.relief + total * of_dug * p.dug * t.craters.frequency;
  ground.value = relief_here.value;
  ground.shape_gradient = rise_of_ridges * p.ridges.gradient;
  ground.gradient = rise * gradient + ground.shape_gradient;
  ground.relief = relief * (rise + rise_of_ridges);
  ground.openness = openness_of(ground.relief);
  lay_ice(ground, direction, t.ice, p.footprint);
  return ground;
}

#ifdef TERRELLA_HOST
Height mapped_height_at(vec3 direction, Terrain t, sampler2D map, float footprint);

#endif
// The ground at a direction (unit), without what samples a footprint (rad) apart can't show.
Height terrain_height_at(vec3 direction, Terrain t, float footprint) {
#ifdef TERRELLA_HOST
  if (t.map.map != nullptr) return mapped_height_at(direction, t, t.map, footprint);
#endif
  HeightParts parts = no_height(footprint);
  float frequency = t.frequency;
  for (int i = 0; i < t.octaves; ++i) {
    Noise n = no_noise();
    if (layer_weight(frequency, footprint) > 0.0) n = height_noise(direction, t, i, frequency);
    add_height_layer(parts, t, i, frequency, n);
    frequency *= t.lacunarity;
  }
  if (t.craters.depth > 0.0) add_craters(direction, t.craters, footprint, parts.dug, parts.dug_gradient);
  return height_of(parts, direction, t);
}

// The outward normal of a surface at radius (planet radii) whose radius changes by slope over the unit sphere. slope:
// along the sphere.
vec3 slope_normal(vec3 direction, float radius, vec3 slope) {
  return normalize(direction - slope / radius);
}

// The outward normal of a surface at radius (planet radii) whose radius changes by gradient over the unit sphere
// (Sandahl (13) as it must be: the gradient divided by the radius, and only its tangential part).
vec3 surface_normal(vec3 direction, float radius, vec3 gradient) {
  return slope_normal(direction, radius, gradient - dot(gradient, direction) * direction);
}
