// A small light.
#include "output.glsl"
#include "lib/stars.glsl"

in vec3 square_light;
in vec2 square_place;

void main() { emit_veil(square_light * soft_disc(dot(square_place, square_place)), 0.0); }
