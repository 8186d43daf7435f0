// The sun as the eye sees it. Angles from its middle are given as tangents.

// Tangent of the angle between a ray (of any length) and the sun (unit); far where the ray leads away from it.
float tangent_from_sun(vec3 ray, vec3 sun) {
  return length(cross(ray, sun)) / max(dot(ray, sun), 1.0e-6 * length(ray));
}

// The disc, 0..1, with an edge about as wide as a pixel. radius, pixel: > 0.
float disc_of_sun(float away, float radius, float pixel) {
  return 1.0 - smoothstep(radius - pixel, radius + pixel, away);
}

// Glare around the disc, as in an eye or a lens: 1 in the middle, about the inverse square of the angle further out, and
// none from reach on. radius, reach: > 0.
float glare_of_sun(float away, float radius, float reach) {
  float x = away / radius;
  float end = max(1.0 - away / reach, 0.0);
  return end * end / (1.0 + 0.5 * x * x);
}

// Light of the sun's disc as a multiple of that which falls on the planet: so bright that every tone curve makes it white,
// and far from what half floats can hold.
const float disc_brightness = 60.0;

// Light of the middle of the glare, in the same measure.
const float glare_brightness = 2.5;

// Tangent of the angle from the sun's middle at which its glare ends.
const float glare_reach = 0.5;
