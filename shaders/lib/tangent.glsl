// Directions along a sphere.

// A unit vector at right angles to n (Duff et al. 2017, "Building an orthonormal basis, revisited").
vec3 perpendicular(vec3 n) {
  float side = n.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (side + n.z);
  return vec3(1.0 + side * n.x * n.x * a, side * n.x * n.y * a, -side * n.x);
}
