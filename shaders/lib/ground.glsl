// The ground as it is seen: its colour by bands of height as in Sandahl 2022 (section 2.1), and, beyond it, slope and
// latitude; and the light that it sends on.
#include "lib/light.glsl"

struct Bands {
  vec3 sand, land, mountain, snow, seabed, sea;  // linear colours; sea: deep water
  float sand_height, mountain_height, snow_height;  // over the water, radii
  float softness;       // 0..1
  float slope_rock;     // 0..1
  float thinning;       // 0..1
  float snow_sine;      // sine of the latitude from which snow lies at the water's edge; above 1: nowhere
  float hollows;        // how much darker hollows are, 0..1
};

// The ground at a place.
struct GroundAt {
  vec3 gradient;   // of the height over the unit sphere, along the sphere
  float openness;  // 0..1, of Height in lib/heights.glsl
  float height;    // over the water, radii
};

// A step at edge that takes softness times scale to rise.
float band(float edge, float scale, float softness, float x) {
  float width = max(scale * softness, 1.0e-6);
  return smoothstep(edge - 0.5 * width, edge + 0.5 * width, x);
}

// height: over the water, radii; steepness: 1 - cosine of the slope, 0..1, or its mean over slopes that spread around one;
// spread: 1 - the length of the mean of their normals, 0..1; sine: of the latitude; variation: -1..1, breaks up the lines
// between bands.
vec3 ground_color(float height, float steepness, float spread, float sine, float variation, Bands b) {
  float scale = max(b.mountain_height, 1.0e-6);
  float x = height + 0.18 * scale * variation;
  float dry = band(0.0, b.sand_height, 1.0, height);
  vec3 color = mix(b.seabed, b.sand, dry) * mix(0.55, 1.0, dry);  // sand is dark where the sea has wetted it
  float up_there = clamp(x / scale, 0.0, 1.0);
  vec3 land = mix(b.land, b.mountain, 0.7 * b.thinning * up_there * up_there);
  color = mix(color, land, band(b.sand_height, scale, 0.35 * b.softness, x));
  color = mix(color, b.mountain, band(b.mountain_height, scale, b.softness, x));
  float bare = b.slope_rock * smoothstep(0.06 - spread, 0.30 + spread, steepness) * step(0.0, height);
  color = mix(color, b.mountain, bare);
  float cold = smoothstep(b.snow_sine - 0.10, b.snow_sine + 0.06, abs(sine) + 0.05 * variation);
  // Where the sea freezes its bottom looks like deep water: between floes narrower than the mesh nothing lies over it.
  color = mix(color, 0.5 * b.sea, cold * (1.0 - dry));
  float snowline = mix(b.snow_height, -0.25 * b.snow_height, cold);
  float snow = band(snowline, max(b.snow_height, 1.0e-6), 0.6 * b.softness, x) * step(-1.0e-3 * scale, height);
  float clings = 1.0 - 0.8 * b.slope_rock * smoothstep(0.16 - spread, 0.5 + spread, steepness);
  return mix(color, b.snow, snow * clings);
}

// Colour of the ground without light, darker in hollows. up: unit; normal: of the ground, or the mean of its normals.
vec3 ground_albedo(vec3 up, GroundAt ground, vec3 normal, Bands bands) {
  // The gradient's share along a fixed axis changes its sign from place to place: enough to break up lines.
  float variation = clamp(dot(ground.gradient, vec3(0.61, -0.52, 0.60)) * 0.8, -1.0, 1.0);
  float spread = max(1.0 - length(normal), 0.0);
  vec3 color = ground_color(ground.height, 1.0 - dot(up, normal), spread, up.z, variation, bands);
  return color * mix(1.0, 0.5 + 0.8 * ground.openness, bands.hollows);
}

// Colour of a ground under a film of water, in which light is thrown back to it many times (Angstrom 1925, "The albedo of various
// surfaces of ground"). part: of the ground that is wet, 0..1.
vec3 wetted(vec3 albedo, float part, float refraction_index) {
  float n2 = refraction_index * refraction_index;
  return mix(albedo, albedo / (n2 * (1.0 - albedo) + albedo), part);
}

// Part of the ground that waves keep wet. height: over the still water; wet_height: to which they run up, of the same unit; 0: nothing
// is wetted.
float wet_part(float height, float wet_height) {
  return wet_height > 0.0 ? 1.0 - smoothstep(0.7, 1.4, height / wet_height) : 0.0;
}

// What noise finer than the map of the ground, -1..1, makes of its colour.
vec3 grained(vec3 albedo, float grain) {
  return albedo * (1.0 + 0.35 * grain);
}

// The mean slope of what an eye sees of a surface whose slopes spread around none: of those that face it, it sees more
// (as in Smith 1967, "Geometrical shadowing of a random rough surface"). variance: of the slope along each axis; up,
// to_eye: unit.
vec3 mean_seen_slope(float variance, vec3 up, vec3 to_eye) {
  float climb = dot(up, to_eye);
  vec3 along = to_eye - climb * up;
  float held = climb * climb + 2.55 * variance * dot(along, along);
  return (-2.0 * variance / max(climb + sqrt(held), 1.0e-3)) * along;
}

// How long the mean is of the unit normals of a surface whose slopes spread around none, 0..1: within 0.02 of what it is
// for a bell curve. variance: of the slope along each axis.
float mean_normal_length(float variance) {
  return 2.0 / (1.0 + sqrt(1.0 + 3.4 * variance));
}

// The mean cosine of incidence over such a surface, of which no part is lit from behind: it fades out where a smooth one
// would end. For a unit normal the cosine itself, held above 0. normal: the mean of unit normals; sun: unit.
float mean_cosine(vec3 normal, vec3 sun) {
  float cosine = dot(normal, sun);
  float square = max(dot(normal, normal), 1.0e-6);
  float spread = max(1.0 - square, 0.0) * max(1.0 - cosine * cosine / square, 0.0);
  return 0.5 * (cosine + sqrt(cosine * cosine + spread / 3.1415926535));
}

// Sunlight that the ground sends on. normal: as mean_cosine takes it; shade: part of the sunlight left by the clouds.
vec3 ground_sunlight(vec3 albedo, vec3 normal, LightAt at, float shade, SceneLight scene) {
  return albedo * at.sun * (0.6 * shade * mean_cosine(normal, scene.sun));
}

// All light that it sends on.
vec3 ground_light(vec3 albedo, vec3 normal, LightAt at, float shade, SceneLight scene) {
  vec3 of_sky = albedo * skylight(at, normal, scene) * (0.6 * mix(0.7, 1.0, shade));
  return ground_sunlight(albedo, normal, at, shade, scene) + of_sky;
}
