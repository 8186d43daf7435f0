// Rings of small bodies, lit by the sun from the side that is seen or through them from the other.
#include "scene_block.glsl"
#include "output.glsl"
#include "lib/rings.glsl"

uniform float side;  // 1: what lies before the planet and its air; -1: what lies behind

in vec3 ring_from_eye;

void main() {
  vec3 place = eye_position() + ring_from_eye;
  float width = rings_outer - rings_inner;
  float across = (length(place) - rings_inner) / width;
  float footprint = max(fwidth(across), 1.0e-6);
  // Whether the ray has yet to come nearest to the planet.
  if (dot(place, ring_from_eye) * side > 0.0) discard;
  vec3 ray = normalize(ring_from_eye), sun = sun_direction.xyz;
  float matter = ring_matter(across, footprint, uint(rings_seed));
  float opacity = ring_opacity(matter, rings_density, ray.z);
  // Many small bodies look as bright from all sides; through a thin part more light comes than through a dense one.
  float through = 0.5 * (1.0 - rings_density * matter);
  float brightness = ray.z * sun.z < 0.0 ? 1.0 : through;
  float lit = planet_shade(place, sun) * smoothstep(0.0, 0.02, abs(sun.z));
  vec3 light = rings_color.rgb * mix(0.7, 1.0, matter) * sun_light.rgb * (0.35 * brightness * lit + 0.02 * sun_ambient);
  emit_veil(light * opacity, opacity);
}
