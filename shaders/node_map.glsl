// Of a ground of nodes whose continents are a map's: what of it pixels can show and vertices can't hold.
#include "lib/finer_ground.glsl"
#include "lib/ground.glsl"
#include "lib/mapped_heights.glsl"
#include "scene_terrain.glsl"
#include "node_inputs.glsl"

uniform highp sampler2D height_map;

const bool node_has_ranges = false;

// As Height and mapped_relief_of have it.
Relief node_relief(float mean, float shape) { return mapped_relief_of(scene_terrain(), mean, shape); }

// All of it that pixels can show, less what vertices hold.
void add_finer_map(inout FinerGround finer, vec3 up, float footprint) {
  vec3 direction = normalize(up + moved(finer));
  MapHeight shown = map_height_at(height_map, direction, footprint);
  MapHeight held = map_height_at(height_map, direction, held_footprint(node_held.x));
  MapHeight held_above = map_height_at(height_map, direction, held_footprint(2.0 * node_held.x));
  float above = node_held.y;
  add_to_shape(finer, shown.value - (1.0 - above) * held.value - above * held_above.value,
               shown.gradient - (1.0 - above) * held.gradient - above * held_above.gradient);
}
