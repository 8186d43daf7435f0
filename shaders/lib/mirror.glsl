// Land as still water on a sphere mirrors it, for an eye as far below the water as the true one is above. r: radius of the water;
// alt > 0: height of the eye over it; lengths of one unit.

// Height over the water of a place. climb: how far up from the true eye it is, along the plumb line there; square: of its distance.
float altitude_seen(float r, float alt, float climb, float square) {
  float away = r + alt;
  float rise = 2.0 * away * climb + square;
  return alt + rise / (sqrt(max(away * away + rise, 0.0)) + away);
}

// How far a place is from the mirrored eye. cosine: of the plumb line and the ray to it; rise: its height over the water as a part of
// that distance. To second order: the sphere falls off by the square of the way.
float way_in_mirror(float r, float alt, float cosine, float rise) {
  float steeper = cosine - rise;
  float fall = (1.0 - cosine) * (1.0 + cosine) / r;
  float root = sqrt(max(steeper * steeper + 2.0 * alt * fall, 0.0));
  return steeper > 0.0 ? 2.0 * alt / (steeper + root) : (root - steeper) / max(fall, 1.0e-9);
}

// Standard deviation (rad) of how high slopes that are not shown throw rays along the water: of those that face the eye (a Rayleigh
// distribution), doubled by the mirror. rough: fourth power of their roughness.
float thrown_spread(float rough) {
  return 0.93 * sqrt(rough);
}

// The level of a mipmap whose texels, at level 0 so wide (rad), are as wide as four rays that spread are apart.
float level_of_spread(float spread, float texel) {
  return log2(max(0.8 * spread / texel, 1.0));
}

// Ray i of four, in standard deviations: in the middle of each quarter of a normal distribution.
float deviation_of_quarter(int i) {
  return i == 0 ? -1.15 : i == 1 ? -0.32 : i == 2 ? 0.32 : 1.15;
}
