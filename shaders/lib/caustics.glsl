// Sunlight that waves gather on the bottom: each wave is a lens. Lengths in planet radii.
#include "lib/short_waves.glsl"

// How strongly the surface bends over a place: minus the second derivatives of its height along two axes, per radius.
struct Lens {
  vec3 power;    // along the first, of both, along the second
  float spread;  // variance of the sum of the first and the last over places
};

Lens no_lens() {
  Lens lens;
  lens.power = vec3(0.0);
  lens.spread = 0.0;
  return lens;
}

// weight: as of add_short_wave.
void add_lens(inout Lens lens, Course course, ShortWave wave, float weight) {
  vec2 d = course.direction;
  float bend = weight * wave.amplitude * wave.wavenumber * wave.wavenumber;
  lens.power += bend * cos_sin(course.phase).y * vec3(d.x * d.x, d.x * d.y, d.y * d.y);
  float all = bend * dot(d, d);
  lens.spread += 0.5 * all * all;
}

// How many times as bright as under a still sea the sun lights the bottom below a lens: by how much smaller the area is that the light
// of one of the surface falls on, held where it would be a point. 1 on average over places, within a tenth (fitted to random seas of all
// depths); far below the focus, where the light of many places meets, the pattern fades. left: of the waves by the shore; way: of the
// light from the surface to the bottom; refraction_index: of the water.
float gathered_light(Lens lens, float left, float way, float refraction_index) {
  float bent = left * way * (1.0 - 1.0 / refraction_index);
  vec3 m = bent * lens.power;
  float area = 1.0 - m.x - m.z + m.x * m.z - m.y * m.y;
  float square = bent * bent * lens.spread;
  float mean = (0.958 + 3.5 * square) / (1.0 + square * (2.2 + 0.15 * square));
  float gain = inversesqrt(area * area + 0.09) / mean;
  return 1.0 + (gain - 1.0) / (1.0 + 0.25 * square);
}
