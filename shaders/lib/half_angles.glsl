// Angles from the tangents of their halves: no inverse cosine, which loses half of the digits near 0 and pi, and no
// function of the driver's, whose arc tangent may be off by thousands of units in the last place. Double precision, which
// others are compared with, asks the library.

// Arc tangent of 0..1, rad. Its relative error is below 2.0e-7 in single precision.
float arc_tangent(float t) {
#ifdef TERRELLA_DOUBLE
  return atan(t);
#else
  // Beyond the tangent of pi/8, what is missing to pi/4.
  bool beyond = t > 0.41421356;
  float x = beyond ? (t - 1.0) / (t + 1.0) : t;
  float xx = x * x;
  float tail = -0.14263955483 + xx * (0.10743730603 - xx * 0.0645192592);
  float angle = x + x * xx * (-0.33333331761 + xx * (0.19999540478 + xx * tail));
  return beyond ? 0.7853981633974483 + angle : angle;
#endif
}

// Tangent of 0..pi/4. Its relative error is below 3.0e-7 in single precision.
float tangent(float angle) {
#ifdef TERRELLA_DOUBLE
  return tan(angle);
#else
  float xx = angle * angle;
  float tail = 0.021621125421 + xx * (0.0099621524303 + xx * (0.0011853145533 + xx * 0.0038431433429));
  return angle + angle * xx * (0.3333333398 + xx * (0.13333230942 + xx * (0.053994465076 + xx * tail)));
#endif
}

// The angle of the point (x, y) from the axis of x, -pi..pi; 0 at the origin. |x|, |y| < 1e18.
float angle_of(float y, float x) {
  float far = sqrt(x * x + y * y) + abs(x);
  float acute = far > 0.0 ? 2.0 * arc_tangent(abs(y) / far) : 0.0;
  float angle = x < 0.0 ? 3.141592653589793 - acute : acute;
  return y < 0.0 ? -angle : angle;
}

// The angle between two vectors of about the same length (within a factor of 2), 0..pi. From the difference of the two
// where they are close and from the sum where they are opposite, so that the sine is never a difference of large numbers:
// its relative error near 0 is that of single precision, times how much their lengths differ by angle.
float angle_between(vec3 a, vec3 b) {
  // Divided by their size after the difference, which that would not leave exact: squares of tiny ones would be lost.
  vec3 b_size = abs(b);
  float scale = 1.0 / max(b_size.x, max(b_size.y, b_size.z));
  vec3 unit = scale * b;
  float cosine = dot(scale * a, unit);
  vec3 rest = scale * (cosine < 0.0 ? a + b : a - b);
  return angle_of(length(cross(rest, unit)), cosine);
}
