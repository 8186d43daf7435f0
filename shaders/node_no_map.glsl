// Of a ground of nodes whose continents are the seed's: layers of noise are all that its vertices may lack.
#include "lib/ground.glsl"

void add_finer_map(inout GroundAt ground, vec3 up, float footprint) {}
