// Of a ground of nodes whose continents are a map's: what of it pixels can show and vertices can't hold.
#include "lib/ground.glsl"
#include "lib/mapped_heights.glsl"
#include "scene_terrain.glsl"
#include "node_inputs.glsl"

uniform highp sampler2D height_map;

const bool node_has_ranges = false;

// As Height and mapped_relief_of have it.
Relief node_relief(float mean, float shape) { return mapped_relief_of(scene_terrain(), mean, shape); }

// What is drawn of it, as node_surface.glsl has it of layers: all that pixels can show, less what vertices hold.
void add_finer_map(inout float shape, inout vec3 gradient, vec3 up, float footprint) {
  MapHeight shown = map_height_at(height_map, up, footprint);
  MapHeight held = map_height_at(height_map, up, node_held.x);
  MapHeight held_above = map_height_at(height_map, up, 2.0 * node_held.x);
  float above = node_held.y;
  shape += shown.value - (1.0 - above) * held.value - above * held_above.value;
  gradient += shown.gradient - (1.0 - above) * held.gradient - above * held_above.gradient;
}
