// Where rays meet spheres. Neither form is the difference of b^2 and c, which from afar are nearly the same.

// The two ways t0 <= t1 along a ray; met is false, and both are 0, where there are none.
struct Roots {
  bool met;
  float t0;
  float t1;
};

// Roots of t^2 + 2 b t + c = 0, given a quarter of the discriminant: the one that does not cancel, and c divided by it.
Roots roots_of(float b, float quarter, float c) {
  float chord = sqrt(max(quarter, 0.0));
  float q = b < 0.0 ? chord - b : -b - chord;
  float other = q == 0.0 ? 0.0 : c / q;
  Roots roots;
  roots.met = quarter >= 0.0;
  roots.t0 = roots.met ? min(q, other) : 0.0;
  roots.t1 = roots.met ? max(q, other) : 0.0;
  return roots;
}

// Half the chord that a sphere around the origin cuts out of a ray, squared; below 0 where the ray passes by. ray: unit;
// along: dot(o, ray). From the ray's place nearest to the origin, so that from far away no more is lost than of that.
float half_chord_square(vec3 o, vec3 ray, float along, float radius) {
  vec3 nearest = o - along * ray;
  return radius * radius - dot(nearest, nearest);
}

// |o + t d| = radius around the origin. d need not be a unit vector but is not 0; t counts its lengths.
Roots ray_sphere(vec3 o, vec3 d, float radius) {
  float size = length(d);
  vec3 ray = d / size;
  float along = dot(o, ray);
  float away = length(o);
  Roots roots = roots_of(along, half_chord_square(o, ray, along, radius), (away - radius) * (away + radius));
  roots.t0 = roots.t0 / size;
  roots.t1 = roots.t1 / size;
  return roots;
}

// Where a ray from an altitude over a sphere of radius r meets the shell at the height h. mu: cosine of the angle between
// the ray and up. Lengths of one unit, r > 0.
Roots ray_shell(float r, float alt, float mu, float h) {
  float away = r + alt;
  float along = away * mu;
  float c = (alt - h) * (2.0 * r + alt + h);
  // From far away the first would be a difference of two large squares, along the ground the second.
  float shell = r + h;
  float nearest = away * sqrt(max((1.0 - mu) * (1.0 + mu), 0.0));
  bool steep = abs(mu) > 0.7;
  float quarter = steep ? (shell - nearest) * (shell + nearest) : along * along - c;
  return roots_of(along, quarter, c);
}
