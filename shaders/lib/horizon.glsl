// How far one sees over a sphere, from altitudes: radius and distance from the centre would lose what lies between.
#include "lib/half_angles.glsl"

// acos(r / (r + alt)): the angle at the centre from the point below the eye to its horizon, rad. alt >= 0, r > 0, any unit.
float cap_angle(float r, float alt) {
  return 2.0 * arc_tangent(sqrt(alt / (2.0 * r + alt)));
}

// The length of the line of sight to the horizon, in the unit of r.
float horizon_distance(float r, float alt) {
  return sqrt(alt * (2.0 * r + alt));
}

// The arc beyond which the sphere hides all that stands no higher than h_max, rad.
float hidden_angle(float r, float alt, float h_max) {
  return cap_angle(r, alt) + cap_angle(r, h_max);
}

// The distance at which an edge that faces the eye in the middle of the picture covers max_px pixels of a width. fov_x:
// horizontal field of view, rad, 0..pi. (The print of Lindner has edge / tan(max_px fov / width), which is up to 7.7 times
// too large.)
float split_distance(float edge, float max_px, float fov_x, float width) {
  // 1 / tan(fov / 2) by the tangent of a quarter.
  float t = tangent(0.25 * fov_x);
  return edge / max_px * width * ((1.0 - t) * (1.0 + t)) / (4.0 * t);
}
