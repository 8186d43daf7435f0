// The persistent grid: a grid fixed to the eye, thrown onto the sphere (Michelic 2018, equations 2 to 4).
#include "lib/horizon.glsl"

struct GridOffset {
  float h;    // line of sight to the horizon
  float s;    // the same from the top of the highest terrain
  float zs;   // how far the grid stands off the centre, cot(phi) (3)
  float phi;  // the angle at the centre that the grid's edge has to reach, rad
};

// r: radius; alt: of the eye, 0 if below; h_max: of the highest terrain, >= 0; all of one unit. alt and h_max are not both
// 0. The angle comes from arc tangents, zs from the same lines of sight: the print is off by kilometres in single precision.
GridOffset grid_offset(float r, float alt, float h_max) {
  GridOffset g;
  float over = max(alt, 0.0);
  g.h = horizon_distance(r, over);
  g.s = horizon_distance(r, h_max);
  g.zs = (r - g.h * (g.s / r)) / (g.h + g.s);
  g.phi = hidden_angle(r, over, h_max);
  return g;
}

// 1 - x^n without cancellation at x = 1, for whole n >= 1: (1 - x)(1 + x + ... + x^(n-1)), the sum by doubling.
float one_less_power(float x, int n) {
  float sum = 0.0;    // of the first m powers
  float power = 1.0;  // x^m; m takes the bits of n from the highest on
  for (int bit = 30; bit >= 0; --bit) {
    if ((n >> bit) == 0) continue;
    sum = sum + sum * power;
    power = power * power;
    if (((n >> bit) & 1) == 0) continue;
    sum = 1.0 + x * sum;
    power = power * x;
  }
  return (1.0 - x) * sum;
}

// How high the grid rises over its square (2): 1 in the middle, 0 along the border. gx, gy: -1..1; n: even, > 0.
float grid_rise(float gx, float gy, int n) {
  return one_less_power(abs(gx), n) * one_less_power(abs(gy), n);
}

// The direction from the centre of the sphere to a vertex, in the axes of camera_axes.
vec3 grid_direction(float gx, float gy, float rise, float zs) {
  return normalize(vec3(gx, gy, rise + zs));
}

// Axes with the third up to the eye (w, unit) and the second at right angles to b, which is not parallel to w: u x v = w.
// (The print's u = w x v mirrors the grid.)
void camera_axes(vec3 w, vec3 b, out vec3 u, out vec3 v) {
  v = normalize(cross(w, b));
  u = cross(v, w);
}

// The vertex relative to an eye at an altitude above the sphere, in the axes of camera_axes and the unit of r. Never as a
// difference of two positions.
vec3 grid_from_eye(vec3 direction, float r, float alt) {
  float across = direction.x * direction.x + direction.y * direction.y;
  float drop = direction.z > 0.0 ? across / (1.0 + direction.z) : 1.0 - direction.z;
  return vec3(r * direction.x, r * direction.y, -r * drop - alt);
}
