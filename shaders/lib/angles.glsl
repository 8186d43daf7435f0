// Angles by polynomials that single precision cannot tell from the true functions, for loops over many waves: drivers
// compute sine and cosine apart and reduce each argument anew. Double precision, which others are compared with, asks the
// library.

// Cosine and sine of any angle, rad. Off by at most 4.0e-7, and 1.8e-7 of the angle (tests/f32).
vec2 cos_sin(float angle) {
#ifdef TERRELLA_DOUBLE
  return vec2(cos(angle), sin(angle));
#else
  float turns = angle * 0.15915494309189535;
  float x = turns - floor(turns + 0.5);
  float xx = x * x;
  // Of half the angle, which lies within a quarter turn: the least error of their degree.
  float s = x * (3.1415925806 + xx * (-5.1677069002 + xx * (2.550031641 + xx * (-0.5980464508 + xx * 0.077222249661))));
  float c = 0.99999995347 + xx * (-4.9347928587 + xx * (4.0584119143 + xx * (-1.3318801621 + xx * 0.21969680012)));
  return vec2(1.0 - 2.0 * s * s, 2.0 * s * c);
#endif
}

// The angle in 0..pi of a given sine (at least 0) and cosine. Its relative error is below 4.0e-7.
float arc(float sine, float cosine) {
#ifdef TERRELLA_DOUBLE
  return atan(sine, cosine);
#else
  float t = sine / (1.0 + abs(cosine));  // tangent of half the angle, or of half what is left to pi
  float tt = t * t;
  float tail = 0.099142949192 + tt * (-0.059486425942 + tt * (0.024252428356 - tt * 0.0046932835962));
  float acute = 2.0 * t * (0.99999990099 + tt * (-0.33331990752 + tt * (0.19969723997 + tt * (-0.14019481582 + tt * tail))));
  return cosine < 0.0 ? 3.141592653589793 - acute : acute;
#endif
}
