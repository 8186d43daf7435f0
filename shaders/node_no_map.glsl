// Of a ground of nodes whose continents are the seed's: layers of noise are all that its vertices may lack.
#include "lib/finer_ground.glsl"
#include "lib/ground.glsl"
#include "scene_terrain.glsl"
#include "node_inputs.glsl"

const bool node_has_ranges = true;

// As Height and relief_of have it.
Relief node_relief(float mean, float shape) { return relief_of(scene_terrain(), mean, shape); }

void add_finer_map(inout FinerGround finer, vec3 up, float footprint) {}
