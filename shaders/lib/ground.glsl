// The colour of the ground: bands by height as in Sandahl 2022 (section 2.1), and, beyond it, slope and latitude.

struct Bands {
  vec3 sand, land, mountain, snow, seabed, sea;  // linear colours; sea: deep water
  float sand_height, mountain_height, snow_height;  // over the water, radii
  float softness;       // 0..1
  float slope_rock;     // 0..1
  float thinning;       // 0..1
  float snow_sine;      // sine of the latitude from which snow lies at the water's edge; above 1: nowhere
};

// A step at edge that takes softness times scale to rise.
float band(float edge, float scale, float softness, float x) {
  float width = max(scale * softness, 1.0e-6);
  return smoothstep(edge - 0.5 * width, edge + 0.5 * width, x);
}

// height: over the water, radii; steepness: 1 - cosine of the slope, 0..1; sine: of the latitude; variation: -1..1, breaks
// up the lines between bands.
vec3 ground_color(float height, float steepness, float sine, float variation, Bands b) {
  float scale = max(b.mountain_height, 1.0e-6);
  float x = height + 0.18 * scale * variation;
  float dry = band(0.0, b.sand_height, 1.0, height);
  vec3 color = mix(b.seabed, b.sand, dry) * mix(0.55, 1.0, dry);  // sand is dark where the sea has wetted it
  float up_there = clamp(x / scale, 0.0, 1.0);
  vec3 land = mix(b.land, b.mountain, 0.7 * b.thinning * up_there * up_there);
  color = mix(color, land, band(b.sand_height, scale, 0.35 * b.softness, x));
  color = mix(color, b.mountain, band(b.mountain_height, scale, b.softness, x));
  float bare = b.slope_rock * smoothstep(0.06, 0.30, steepness) * step(0.0, height);
  color = mix(color, b.mountain, bare);
  float cold = smoothstep(b.snow_sine - 0.10, b.snow_sine + 0.06, abs(sine) + 0.05 * variation);
  // Where the sea freezes its bottom looks like deep water: between floes narrower than the mesh nothing lies over it.
  color = mix(color, 0.5 * b.sea, cold * (1.0 - dry));
  float snowline = mix(b.snow_height, -0.25 * b.snow_height, cold);
  float snow = band(snowline, max(b.snow_height, 1.0e-6), 0.6 * b.softness, x) * step(-1.0e-3 * scale, height);
  float clings = 1.0 - 0.8 * b.slope_rock * smoothstep(0.16, 0.5, steepness);
  return mix(color, b.snow, snow * clings);
}
