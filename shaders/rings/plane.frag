// Rings of small bodies.
#include "ring_block.glsl"

uniform float side;  // 1: what lies before the planet and its air; -1: what lies behind

in vec3 ring_from_eye;

void main() {
  vec3 place = eye_position() + ring_from_eye;
  Rings rings = scene_rings();
  float footprint = max(fwidth(across_rings(place, rings)), 1.0e-6);
  // Whether the ray has yet to come nearest to the planet.
  if (dot(place, ring_from_eye) * side > 0.0) discard;
  Veil veil = ring_veil(place, normalize(ring_from_eye), rings, footprint, scene_light());
  emit_veil(veil.light, veil.opacity);
}
