// From light to a picture.

// Brightness to the eye of linear light in the sRGB primaries.
float luminance(vec3 light) {
  return dot(light, vec3(0.2126, 0.7152, 0.0722));
}

// A curve with a toe and a shoulder that keeps 0 and never passes 1 (Narkowicz 2015, a fit to the ACES film curve).
float filmic(float x) {
  float c = min(max(x, 0.0), 1.0e4) * 0.6;
  return clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
}

// Fits light >= 0 into 0..1. curve: 0 filmic, 1 Reinhard, 2 cut off.
vec3 tone_map(vec3 light, int curve) {
  if (curve == 0) return vec3(filmic(light.x), filmic(light.y), filmic(light.z));
  if (curve == 1) return light / (1.0 + luminance(light));
  return clamp(light, 0.0, 1.0);
}

// The sRGB curve (IEC 61966-2-1), 0..1 to 0..1, within 4e-5: a hundredth of a step of 8 bits. Above its straight part it is
// fitted in roots: with powers the pass that fits light to the screen takes a quarter longer on a processor.
float srgb_encode(float x) {
  float root = sqrt(x);
  float fourth = sqrt(root);
  float curve = 1.11754 * root + 0.197817 * fourth - 0.329026 * root * fourth + 0.078471 * x - 0.064802;
  return x <= 0.0031308 ? 12.92 * x : curve;
}

vec3 srgb(vec3 linear_light) {
  vec3 c = clamp(linear_light, 0.0, 1.0);
  return vec3(srgb_encode(c.x), srgb_encode(c.y), srgb_encode(c.z));
}

// Noise of -1..1 with a triangular density and an even spectrum over neighbouring pixels, so that 8 bits show no bands
// (a remapped interleaved gradient noise, Jimenez 2014). pixel: whole numbers below 65536.
float dither(vec2 pixel) {
  float u = fract(52.9829189 * fract(0.06711056 * pixel.x + 0.00583715 * pixel.y));
  float x = 2.0 * u - 1.0;
  return x >= 0.0 ? 1.0 - sqrt(1.0 - x) : sqrt(1.0 + x) - 1.0;
}
