// The shadow of the rings as a veil before all that it falls on.
#include "ring_block.glsl"

in vec3 surface_from_eye;

void main() { emit_veil(vec3(0.0), ring_shadow(eye_position() + surface_from_eye, scene_rings(), scene_light())); }
