// Light along a ray, gathered from front to back (Michelic 2018, equations 13 to 20, with what the print lacks: the light
// so far is kept, steps are integrated exactly, and emptiness has no negative density).

// (1 - e^-x) / x: how much of the light that a step sends out leaves it, 1 at 0. Never a difference of near numbers.
float mean_transmittance(float x) {
  float y = abs(x);
#ifdef TERRELLA_DOUBLE
  float near = 0.5 * y == 0.0 ? 1.0 : exp(-0.5 * y) * sinh(0.5 * y) / (0.5 * y);
#else
  float tail = -0.041659255296 + y * (0.0083011703016 + y * (-0.0013248178205 + y * 0.0001374241387));
  float near = 1.0 + y * (-0.49999999126 + y * (0.1666660366 + y * tail));
#endif
  float mean = y < 1.0 ? near : (1.0 - exp(-y)) / y;
  return x < 0.0 ? exp(-x) * mean : mean;
}

// 1 - e^-x: what a step takes away.
float absorbed_share(float x) {
  return x < 1.0 ? x * mean_transmittance(x) : 1.0 - exp(-x);
}

// A product and what its rounding lost (Dekker 1971). Both factors below 2^114, so that their upper halves are found.
vec2 exact_product(float a, float b) {
  float product = a * b;
#ifdef TERRELLA_DOUBLE
  return vec2(product, 0.0);
#else
  float a_high = a * 4097.0 - (a * 4097.0 - a);
  float b_high = b * 4097.0 - (b * 4097.0 - b);
  float a_low = a - a_high;
  float b_low = b - b_high;
  return vec2(product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low);
#endif
}

// Part of the light that is left after a way through an absorber. extinction: per length, both >= 0. What the rounding of
// a depth loses is as much of what is left.
float left_after(float extinction, float way) {
  // The larger by the smaller: where that is huge, units are changed so that it is not.
  float large = max(extinction, way);
  float small = min(extinction, way);
  float unit = large > 1.0e30 ? 5.421010862427522e-20 : 1.0;  // 2^-64
  vec2 depth = exact_product(large * unit, small / unit);
  // Nothing is left after more than this, and nobody knows what rounding has lost of an infinity.
  return depth.x < 800.0 ? exp(-depth.x) * (1.0 - depth.y) : 0.0;
}

struct Marched {
  float transmittance;  // from the eye to here
  float light;          // gathered so far
};

Marched not_marched() {
  Marched m;
  m.transmittance = 1.0;
  m.light = 0.0;
  return m;
}

// One step through a cloud (15), (16). density: below 0 counts as none; extinction, scattering: per unit of density and
// length; light: what reaches the step, times the phase function.
void march_cloud(inout Marched m, float density, float length_of_step, float extinction, float scattering, float light) {
  float matter = max(density, 0.0) * length_of_step;
  float depth = extinction * matter;
  // The matter whose light leaves the step. Divided by what dims it where there is much: a depth may be an infinity.
  float seen = depth < 1.0 ? matter * mean_transmittance(depth) : absorbed_share(depth) / extinction;
  m.light += m.transmittance * scattering * seen * light;
  m.transmittance *= exp(-depth);
}

// One segment of air and cloud together (17) to (20): what each lets through, and the light each adds.
void march_segment(inout Marched m, float air, float air_light, float cloud, float cloud_light) {
  m.light += (air_light * cloud + cloud_light) * m.transmittance;
  m.transmittance *= air * cloud;
}

// How dense a layer of clouds is at an altitude (13), 0 at its bottom and top, 1 in the middle. All of one unit, bottom <
// top.
float cloud_signal(float alt, float bottom, float top) {
  float thickness = top - bottom;
  float above = clamp((alt - bottom) / thickness, 0.0, 1.0);
  float below = clamp((top - alt) / thickness, 0.0, 1.0);
  return 4.0 * above * below;
}
