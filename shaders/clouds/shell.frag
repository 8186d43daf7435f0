// The shell of clouds where its map is as fine as the pixels.
#include "cloud_surface.glsl"

void main() { emit_clouds(cloud_of_map()); }
