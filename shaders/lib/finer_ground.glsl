// Ground that the vertices of a mesh tell only as finely as they stand, as finely as a pixel can show it: layers that they
// lack are added one by one, and from one to the next the pixel's ray goes on to where it meets the ground that is known by
// then. So the picture is off by what triangles miss of the ground only where they end, before what lies behind them.
#include "lib/heights.glsl"

// What is added to one of the means of Height, and to its gradient over the unit sphere.
struct Added {
  float value;
  vec3 gradient;
};

// A ray from where it meets the mesh on.
struct GroundRay {
  vec3 along;     // what it moves over the unit sphere for each radius of its length
  float climb;    // what it rises for each
  float way;      // how far it has gone on, radii; negative: back to the eye
  float over;     // how high it is there over the ground, radii
  float closing;  // how much less that becomes for each radius
};

// The ground at the end of the ray.
struct FinerGround {
  Added mean, shape;  // of Height: to be added to what the vertices tell
  float rise_of_mean, rise_of_shape;  // how much each raises the ground on which the ray ends
  float all_layers, all_ridges;  // sums of amplitudes that both means are of
  float relief;       // as openness_of takes it, of a ground as high as all_layers
  float curvature;    // of the hills that were added, as far as most of them bend, radii for each square of the unit sphere
  float bent;         // by about how much the ray has missed them as they bend, radii
  GroundRay ray;
};

// How high a mesh lies over the ground that its vertices tell, but for the sphere's own bend. Between them that ground
// bends: if it does so evenly, by half of what slopes differ that are interpolated likewise. over: at a vertex; slope: of
// the ground there over the unit sphere, along it; place: from anywhere that is the same for all, radii.
float over_at_vertex(float over, vec3 slope, vec3 place) { return over + 0.5 * dot(slope, place); }

// over: over_at_vertex, interpolated as the slope and the place.
float over_between(float over, vec3 slope, vec3 place) { return over - 0.5 * dot(slope, place); }

// How much lower the mesh lies there than its vertices, as the sphere bends under it. square: of places, interpolated.
float sag_between(float square, vec3 place) { return 0.5 * max(square - dot(place, place), 0.0); }

// How far apart (rad) samples are that vertices tell the ground for. The finest layers that they show bend too much from one to
// the next to be found on a straight line between them: those are left to pixels. Where spacing (rad) is wide, seen from far
// away, half as much is: there pixels would have to add nearly all of the ground.
float held_footprint(float spacing) {
  return clamp(0.005, 2.0 * spacing, 4.0 * spacing);
}

// How much of a layer the vertices hold. frequency: cells per radian; spacing: theirs, rad; above: part to which they tell what
// those of the level above do, twice as far apart.
float held_weight(float frequency, float spacing, float above) {
  return mix(layer_weight(frequency, held_footprint(spacing)), layer_weight(frequency, held_footprint(2.0 * spacing)), above);
}

// ray: from the eye, unit; 0: none, the ground right below is asked for. up: unit, of the place; slope: of what the
// vertices tell; over: height of the place over that, radii.
GroundRay ray_at_mesh(vec3 ray, vec3 up, vec3 slope, float over) {
  GroundRay r;
  r.climb = dot(ray, up);
  r.along = ray - r.climb * up;
  r.way = 0.0;
  r.over = over;
  r.closing = dot(slope, r.along) - r.climb;
  return r;
}

// The sums of amplitudes that means are of: of all layers, and of the ridges of ranges.
float all_layers_of(Terrain t) { return max(amplitude_sum(t.persistence, t.octaves), 1.0e-6); }
float all_ridges_of(Terrain t) { return max(all_layers_of(t) - amplitude_sum(t.persistence, t.ranges.first), 1.0e-6); }

// held: of what the vertices tell; ray: at the mesh; spacing: of the vertices, footprint: of the pixel, rad. Where vertices
// stand as close as pixels do, the mesh shows more of the ground than a pixel knows, and the ray ends there.
FinerGround held_ground(Terrain t, Relief held, GroundRay ray, float spacing, float footprint) {
  float finer = clamp(spacing / footprint - 1.0, 0.0, 1.0);
  FinerGround g;
  g.mean.value = 0.0;
  g.mean.gradient = vec3(0.0);
  g.shape = g.mean;
  g.rise_of_mean = finer * held.by_mean;
  g.rise_of_shape = finer * held.by_shape;
  g.all_layers = all_layers_of(t);
  g.all_ridges = all_ridges_of(t);
  g.relief = 0.0;
  g.curvature = 0.0;
  g.bent = 0.0;
  g.ray = ray;
  g.ray.over *= finer;
  return g;
}

// The same for a ray that has found its way before: layers are looked up where that ended, not where it meets the mesh.
FinerGround once_more(FinerGround begun, float way) {
  FinerGround g = begun;
  g.ray.way = way;
  g.ray.over -= way * g.ray.closing;
  return g;
}

// How far the ray may have ended off the ground, as layers were looked up before it ended: across it, radii.
float doubt_of(FinerGround g) {
  return (abs(g.ray.over) + g.bent) * length(g.ray.along);
}

// How much (0..1) a second ray is to count, which begins once more: from a twentieth of a sample's width of doubt on, and
// wholly from 0.3 on: a step would show where levels of detail change. across: that width, radii.
float part_in_doubt(FinerGround g, float across) {
  return clamp(4.0 * doubt_of(g) / across - 0.2, 0.0, 1.0);
}

// What two rays have found that began once and once more, between both.
FinerGround between_rays(FinerGround first, FinerGround second, float part) {
  FinerGround g = second;
  g.mean.value = mix(first.mean.value, second.mean.value, part);
  g.mean.gradient = mix(first.mean.gradient, second.mean.gradient, part);
  g.shape.value = mix(first.shape.value, second.shape.value, part);
  g.shape.gradient = mix(first.shape.gradient, second.shape.gradient, part);
  g.relief = mix(first.relief, second.relief, part);
  g.ray.way = mix(first.ray.way, second.ray.way, part);
  return g;
}

// Where the ray is: what is to be added to the direction at which it meets the mesh.
vec3 moved(FinerGround g) { return g.ray.way * g.ray.along; }

// Moves the ray to where it meets the ground, if that goes on as steeply: that can be told for a part of the finest hills,
// and for less of them the more it grazes them. So it may stop early. width: of those hills, radii.
void go_on(inout FinerGround g, float width) {
  float closing = max(g.ray.closing, 0.1), reach = 0.5 * closing * width;
  float way = clamp(g.ray.over / closing, -reach, reach);
  g.ray.way += way;
  g.bent += 0.5 * g.curvature * way * way * dot(g.ray.along, g.ray.along);
  g.ray.over -= way * g.ray.closing;
  g.mean.value += way * dot(g.mean.gradient, g.ray.along);
  g.shape.value += way * dot(g.shape.gradient, g.ray.along);
}

// The same before hills of a frequency (cells per radian) are added. Hills that vertices don't tell, but that the mesh shows,
// are where it shows them. spacing: of its vertices, rad.
void go_on_to(inout FinerGround g, float frequency, float spacing) {
  go_on(g, clamp(2.0 * spacing * frequency - 1.0, 0.0, 1.0) / frequency);
}

void add_to_mean(inout FinerGround g, float value, vec3 gradient) {
  g.mean.value += value;
  g.mean.gradient += gradient;
  g.ray.over -= g.rise_of_mean * value;
  g.ray.closing += g.rise_of_mean * dot(gradient, g.ray.along);
}

void add_to_shape(inout FinerGround g, float value, vec3 gradient) {
  g.shape.value += value;
  g.shape.gradient += gradient;
  g.ray.over -= g.rise_of_shape * value;
  g.ray.closing += g.rise_of_shape * dot(gradient, g.ray.along);
}

// How much a layer that is no ridge bends, in its cells, in nine of ten places at the most (tests/laws/finer_ground_test.cpp).
const float layer_bend = 8.0;

// About the same of the rims and bowls of craters, in their cells.
const float crater_bend = 10.0;

// Layer i of the ground's noise. amplitude: of what of it is added; n: at the place to which the ray has moved.
void add_finer_layer(inout FinerGround g, Terrain t, int i, float frequency, float amplitude, Noise n) {
  float added = amplitude * (layer_value(n.value, t.ridged, t.sharpness) - layer_mean(t.ridged));
  float slope = amplitude * frequency * layer_slope(n.value, t.ridged, t.sharpness);
  add_to_mean(g, added / g.all_layers, (slope / g.all_layers) * n.gradient);
  if (i > 0) g.relief += frequency * added;
  float bend = amplitude * layer_bend * frequency * frequency;
  g.curvature += bend / g.all_layers * g.rise_of_mean;
  if (t.ranges.part <= 0.0 || i < t.ranges.first) return;
  float ridge = amplitude * (layer_value(n.value, true, t.sharpness) - layer_mean(true));
  float ridge_slope = amplitude * frequency * layer_slope(n.value, true, t.sharpness);
  g.curvature += bend / g.all_ridges * g.rise_of_shape;
  add_to_shape(g, ridge / g.all_ridges, (ridge_slope / g.all_ridges) * n.gradient);
}

// Craters of size i. direction: where the ray meets the mesh, unit; shown: part of their depth that is added.
void add_finer_craters(inout FinerGround g, Terrain t, vec3 direction, int i, float frequency, float shown) {
  float dug = 0.0;
  vec3 slope = vec3(0.0);
  add_craters_of_size(normalize(direction + moved(g)), i, frequency, t.craters.seed, t.craters.depth * shown, dug, slope);
  g.curvature += g.rise_of_mean / t.height * t.craters.depth * shown * crater_bend * frequency;
  add_to_mean(g, dug / t.height, slope / t.height);
  g.relief += g.all_layers / t.height * dug * t.craters.frequency;
}
