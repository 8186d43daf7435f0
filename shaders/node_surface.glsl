// What pixels know of a ground of nodes: what the vertices tell, and the layers that those can't hold from themselves.
// node_map.glsl or node_no_map.glsl stands before it.
#include "ground_map.glsl"
#include "anchored_layers.glsl"
#include "lib/finer_ground.glsl"
#include "node_inputs.glsl"

// Part of the ground at the pixel that no ice covers, which node_ground finds.
float bare_at_pixel = 1.0;

float held_of_layer(float frequency) { return held_weight(frequency, node_held.x, node_held.y); }

// Of vertices, rad.
float node_spacing() { return (1.0 + node_held.y) * node_held.x; }

// How much a layer lifts the ground for each unit of its value, and how much one does that is a ridge of ranges.
vec2 rises_of(Relief r, Terrain t) {
  return vec2(r.by_mean / all_layers_of(t), node_has_ranges ? r.by_shape / all_ridges_of(t) : 0.0);
}

// How many times as much something lifts the ground where pixels add to what the vertices hold of it.
float times_as_much(float all, float held) { return held > 0.0 ? min(all / held, 4.0) : 1.0; }

// How strongly layers act, for unseen_slopes, which takes all of them for as steep as those that are no ridges of ranges.
// Those ridges are the ones that a ridged ground has anyway, so that both rise together; else one knows nothing of the other.
float layer_rise(GroundAt ground) {
  Terrain t = scene_terrain();
  vec2 rises = rises_of(node_relief(node_height.y, node_height.z), t);
  float steeper = layer_slope_square(true, t.sharpness) / layer_slope_square(t.ridged, t.sharpness);
  float together = t.ridged ? 2.0 * rises.x * rises.y : 0.0;
  float square = rises.x * rises.x + together + steeper * rises.y * rises.y;
  return bare_at_pixel * sqrt(square) * all_layers_of(t);
}

// Craters that the vertices can't hold and a pixel can. They are told from the direction itself: where pixels come near to
// what a float knows of it, the vertices hold them all.
void add_craters_to(inout FinerGround finer, Terrain t, vec3 up, float footprint) {
  if (t.craters.depth <= 0.0 || t.height <= 0.0) return;
  float frequency = t.craters.frequency;
  for (int i = 0; i < t.craters.sizes; ++i) {
    float weight = crater_weight(frequency, footprint);
    if (weight <= 0.0) break;  // and so is that of all smaller ones
    float shown = max(weight - held_of_layer(crater_detail * frequency), 0.0);
    if (shown > 0.0) {
      go_on_to(finer, frequency, node_spacing());
      add_finer_craters(finer, t, up, i, frequency, shown);
    }
    frequency *= crater_step;
  }
}

// Layers that the vertices can't hold and a pixel can.
void add_layers_to(inout FinerGround finer, Terrain t, vec3 from_anchor, float footprint) {
  float amplitude = node_layers.y;
  for (int i = int(node_layers.x); i < int(ground_map_scale.z); ++i) {
    float frequency = layer_place[i].w;
    float weight = layer_weight(frequency, footprint);
    if (weight <= 0.0) break;  // and so is that of all finer layers
    float shown = amplitude * max(weight - held_of_layer(frequency), 0.0);
    amplitude *= t.persistence;
    if (shown <= 0.0) continue;
    go_on_to(finer, frequency, node_spacing());
    add_finer_layer(finer, t, i, frequency, shown, layer_noise(i, from_anchor + moved(finer)));
  }
}

// Ice at the pixel, where vertices tell only whether each has any: floes have their edges, and islands in them their shores, as
// fine as pixels are. own: height of the ground itself over the water, which vertices under ice don't tell.
void lay_ice_at_pixel(inout GroundAt ground, Terrain t, vec3 up, float own, float footprint) {
  if (node_height.w > 0.0) ground.height = own;
  float height = ground.height + t.ice.sea;
  if (!raised_to_ice(height, up, t.ice, footprint)) return;
  ground.height = height - t.ice.sea;
  ground.gradient = vec3(0.0);
  ground.openness = openness_of(relief_of_ice);
  bare_at_pixel = 0.0;
}

// The ground at the pixel as fine as it can show it: vertices tell the means of what they hold of it, the pixel adds what
// they can't. place: where its ray meets the mesh, from the eye; moved along the ray to
// where it meets the ground. ray: from the eye, unit; 0: the ground right below the place is asked for, which stays.
GroundAt node_ground(inout vec3 place, vec3 ray) {
  Terrain t = scene_terrain();
  t.ranges.part = node_has_ranges ? t.ranges.part : 0.0;
  vec3 up = normalize(eye_position() + place), slope = node_slope.xyz;
  // By the angle at which the vertices' ground is seen, and how far apart samples would be that look straight at it.
  float footprint = pixel_footprint(normalize(up - slope), place, 0.12), across = pixel_footprint(-ray, place, 1.0);
  float bare = 1.0 - node_height.w;
  Relief held = node_relief(node_height.y, node_height.z), rising = held;
  rising.by_mean *= bare;
  rising.by_shape *= bare;
  float over = over_between(node_held.z, slope, node_place.xyz);
  float sag = sag_between(node_place.w, node_place.xyz);
  FinerGround begun = held_ground(t, rising, ray_at_mesh(ray, up, slope, over - sag), node_spacing(), footprint);
  FinerGround finer = begun, first = begun;
  float doubtful = 0.0;
  for (int pass = 0; pass < 2; ++pass) {
    if (pass > 0) finer = once_more(begun, first.ray.way);
    add_layers_to(finer, t, direction_from_anchor(place), footprint);
    add_craters_to(finer, t, up, footprint);
    add_finer_map(finer, up, footprint);
    go_on(finer, 4.0 * footprint);
    if (pass > 0) break;
    doubtful = part_in_doubt(finer, across);
    if (doubtful <= 0.0) break;
    first = finer;
  }
  if (doubtful > 0.0) finer = between_rays(first, finer, doubtful);
  place += finer.ray.way * ray;
  Relief all = node_relief(node_height.y + finer.mean.value, max(node_height.z + finer.shape.value, 0.0));
  vec2 rises = rises_of(all, t), held_rises = rises_of(held, t);
  float relief = times_as_much(rises.x + rises.y, held_rises.x + held_rises.y) * node_slope.w;
  GroundAt ground;
  ground.openness = openness_of(relief + bare * (rises.x + rises.y) * finer.relief);
  ground.height = node_height.x - over + bare * (all.value - held.value) + dot(slope, moved(finer));
  vec3 gradient = times_as_much(all.by_mean, held.by_mean) * (slope - node_shape_slope) +
                  times_as_much(all.by_shape, held.by_shape) * node_shape_slope +
                  bare * (all.by_mean * finer.mean.gradient + all.by_shape * finer.shape.gradient);
  ground.gradient = gradient - dot(gradient, up) * up;
  bare_at_pixel = bare;
  lay_ice_at_pixel(ground, t, up, all.value - t.ice.sea, footprint);
  return ground;
}
