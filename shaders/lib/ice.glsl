// Ice that floats on the sea around the poles. It is ground that lies a little over the water: drawn like all ground, it
// costs a frame nothing.
#include "lib/noise.glsl"

struct Ice {
  float sea;   // height of the water over the sphere, radii; at most 0: no water
  float sine;  // of the latitude from which ice lies on it; above 1: nowhere
  uint seed;
};

// Sine of the latitude (deg) from which on something lies around the poles; above 1 from 90 on: nowhere.
float polar_sine(float latitude) {
  return latitude < 90.0 ? sin(radians(latitude)) : 2.0;
}

// Height of ice over the water, radii.
const float ice_thickness = 0.0012;

// How far a place lies within the ice: negative beyond its edge and in the cracks between floes, about in radians. The
// latitude's sine alone decides, but for bays and floes of noise. footprint: rad.
float ice_cover(vec3 direction, Ice ice, float footprint) {
  float over = abs(direction.z) - ice.sine;
  vec3 frequencies = vec3(6.0, 30.0, 17.0);  // of bays, of floes, of the cracks between them
  vec3 noises = vec3(0.0);
  for (int i = 0; i < 3; ++i) {  // a third of the code to compile
    noises[i] = simplex_noise(ivec3(0), frequencies[i] * direction, ice.seed + 901u + uint(i)).value;
  }
  float within = over + 0.035 * noises.x + 0.02 * noises.y * layer_weight(frequencies.y, footprint);
  // Cracks open towards the edge and close at the pole.
  float crack = (abs(noises.z) - 0.16 * (1.0 - smoothstep(0.0, 0.12, within))) * 0.05;
  return min(within, crack);
}

// Whether there can be ice at a place at all.
bool ice_near(vec3 direction, Ice ice) {
  return ice.sine <= 1.0 && ice.sea > 0.0 && abs(direction.z) > ice.sine - 0.08;
}

// Height of the ice's upper side over the sphere, radii; under water, of its foot, so that it ends in a slope.
float ice_height(float cover, Ice ice) {
  return ice.sea + clamp(cover, -0.04, ice_thickness);
}
