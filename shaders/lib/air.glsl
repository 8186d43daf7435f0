// Air as a thin shell of light (Sandahl 2022, section 2.4 and equation 19), made whole: it is brightest at the planet's
// limb and fades to nothing at its outer edge, holds from outside and from within, and thins with the path before a
// surface. Lengths in planet radii, the planet's ground being the unit sphere.
#include "lib/horizon.glsl"
#include "lib/optics.glsl"
#include "lib/rays.glsl"

struct Air {
  float top;        // radius of the outer edge, > 1
  float density;    // opacity along the limb, 0..1
  float exponent;   // a of (1 - V.N)^a
  float wrap;       // w of (19)
  vec3 color;       // by day
  vec3 dusk;        // where the sun stands low
};

// The piece of a ray that lies in the shell.
struct AirPath {
  float enter;   // distance along the ray, >= 0
  float leave;   // >= enter; equal where the ray misses the shell
  float cosine;  // V.N where the ray crosses the shell's edge, 0..1
};

// (1 - cosine)^a with the cosine held to 0..1 and x^0 = 1 (Sandahl 2.4, V being the view direction).
float fresnel_alpha(float cosine, float a) {
  float c = clamp(cosine, 0.0, 1.0);
  float x = 1.0 - c;
  if (a == 0.0) return 1.0;
  float lost = (1.0 - x) - c;  // by rounding: a times as much of x^a
  return x > 0.0 ? pow(x, a) * (1.0 + a * lost / x) : 0.0;
}

// Where a ray crosses a sphere around the centre. eye: position; ray: unit. Cheaper than ray_sphere: of the two ends only
// the one that lies near the eye loses digits, as much as the eye's own place has lost.
AirPath air_path(vec3 eye, vec3 ray, float top) {
  float along = dot(eye, ray);
  float chord = sqrt(max(half_chord_square(eye, ray, along, top), 0.0));
  AirPath path;
  path.enter = max(-along - chord, 0.0);
  path.leave = max(-along + chord, path.enter);
  path.cosine = chord / top;
  return path;
}

// Opacity along the whole of a ray's way through the shell, 0..1. cosine: of AirPath. The limb is where the ray touches
// the ground: (1 - V.N)^a inside of it, fading to 0 at the outer edge.
float air_opacity(float cosine, Air air) {
  float limb = horizon_distance(1.0, air.top - 1.0) / air.top;
  float inside = fresnel_alpha((cosine - limb) / max(1.0 - limb, 1.0e-6), air.exponent);
  float rim = clamp(cosine / max(limb, 1.0e-6), 0.0, 1.0);
  return air.density * inside * rim * rim * rim;
}

// Opacity of a part of a ray's way, when the whole way has the given opacity: optical depth grows with the path. The
// whole way runs from edge to edge of the shell, or twice to the ground where it meets that, so that it changes
// smoothly over the limb. cosine: of AirPath; path: length of the part, >= 0.
float air_opacity_before(float opacity, float cosine, float path, float top) {
  float half_chord = cosine * top;
  float under = max(half_chord * half_chord - (top - 1.0) * (top + 1.0), 0.0);
  float whole = 2.0 * (half_chord - sqrt(under));
  float depth = -log(max(1.0 - opacity, 1.0e-4));
  return 1.0 - exp(-depth * clamp(path / max(whole, 1.0e-6), 0.0, 1.0));
}

// Part of the light from infinity that passes beside the planet's air, 0..1: all outside of it, and nothing deeper in it
// than a quarter of its height, where its own light is so bright that no star is seen. From outside or from just within;
// eye, ray: as above.
float sky_past_air(vec3 eye, vec3 ray, float top) {
  AirPath path = air_path(eye, ray, top);
  float beside = top * sqrt(max(1.0 - path.cosine * path.cosine, 0.0));
  float nearest = dot(eye, ray) < 0.0 ? beside : length(eye);  // what lies behind the eye hides nothing
  return path.leave > path.enter ? smoothstep(0.25 + 0.75 * top, top, nearest) : 1.0;
}

// The glow that a low sun spreads over the sky of those within the air, as a part of the sunlight. climb: cosine between
// the zenith and the sun; dusk: colour of the air where the sun stands low.
vec3 glow_of_sky(float climb, vec3 dusk) {
  float low = smoothstep(-0.25, 0.0, climb) * (1.0 - smoothstep(0.1, 0.5, climb));
  return mix(vec3(1.0), dusk, 0.8 * low) * ((0.25 + low) * smoothstep(-0.3, -0.02, climb));
}

// How much of it is seen along a ray, but for its bright middle. toward: cosine between the ray and the sun.
float wide_glow(float toward) {
  float t = max(toward, 0.0);
  return 0.5 * t * t * t * t * t * t;
}

// Light that the air at a place gives: day, dusk, night. up: unit, from the centre to the place; sun: unit.
vec3 air_light(vec3 up, vec3 sun, Air air) {
  float height = dot(up, sun);
  float day = wrap_diffuse(height, air.wrap);
  float low = smoothstep(-air.wrap, 0.05, height) * (1.0 - smoothstep(-0.02, 0.26, height));
  return mix(air.color, air.dusk, 0.6 * low) * day;
}
