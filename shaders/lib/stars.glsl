// Small lights in a picture: stars and towns.
#include "lib/light.glsl"
#include "lib/night.glsl"
#include "lib/noise.glsl"

// Brightness around the middle of a light, smooth at any place between pixels: 1 in the middle, 0 from two radii on.
// away2: square of the distance in radii.
float soft_disc(float away2) {
  return max(exp(-1.8 * away2) - exp(-1.8 * 4.0), 0.0);
}

// Radius of a star, pixels. size: of all; brightness: of the star, 0..1.
float star_radius(float size, float brightness) {
  return size * (0.8 + 0.8 * brightness);
}

// Light of the middle of a star, before what stands before the sky. brightness: of the star, 0..1, and of all.
vec3 star_light(vec3 color, float brightness, float all) {
  return color * (all * (0.10 + 2.2 * brightness));
}

// Colours along the black body's line, of about the same luminance. warmth: -1 (red) to 1 (blue).
vec3 star_color(float warmth) {
  vec3 white = vec3(1.0, 0.96, 0.92);
  return warmth > 0.0 ? mix(white, vec3(0.62, 0.76, 1.25), warmth) : mix(white, vec3(1.3, 0.80, 0.50), -warmth);
}

// Half the width of the band of far stars, as a sine.
const float band_half_width = 0.2;

// Noise drawn out along the band. normal: unit, of the plane that it lies around.
float band_noise(vec3 direction, vec3 normal, float frequency, uint seed) {
  vec3 place = direction + 1.2 * dot(direction, normal) * normal;
  return simplex_noise(ivec3(0), frequency * place, seed).value;
}

// How bright the band is at a direction, 0..1: clouds of stars, and dust that hides some along the middle.
float band_brightness(vec3 direction, vec3 normal, uint seed) {
  float across = dot(direction, normal) / band_half_width;
  float clouds = band_noise(direction, normal, 2.5, seed);
  float veils = band_noise(direction, normal, 7.0, seed + 1u);
  float wisps = band_noise(direction, normal, 15.0, seed + 2u);
  float edge = abs(across) * (1.25 - 0.25 * clouds - 0.2 * veils);
  float shape = 1.0 - smoothstep(0.0, 1.0, edge);
  float from_dust = abs(across + 0.22 * clouds + 0.1 * wisps) + 0.3 * veils + 0.12 * wisps;
  float clear = smoothstep(-0.05, 0.3, from_dust);
  return min(shape * (0.3 + 0.7 * clear) * (0.75 + 0.2 * clouds + 0.25 * veils + 0.15 * wisps), 1.0);
}

// Light of the far stars that are too many to be told apart: warm where it is faint, for dust reddens it.
vec3 band_light(float brightness, float all) {
  vec3 color = mix(vec3(1.0, 0.86, 0.72), vec3(0.72, 0.84, 1.1), brightness);
  return color * (0.085 * brightness * all);
}

// A light on the ground as it is seen.
struct TownLight {
  vec3 light;    // of its middle
  float radius;  // pixels
};

// It is as wide as a town, and never smaller than a pixel, but dimmer. place: of the light; offset: to it from the eye;
// brightness: of it, 0..1; pixel: angle of a pixel, rad.
TownLight town_light(vec3 place, vec3 offset, float brightness, vec3 color, float all, float pixel, SceneLight scene) {
  vec3 up = normalize(place);
  float away = length(offset);
  float facing = clamp(-2.5 * dot(up, offset) / away, 0.0, 1.0);
  float wide = 0.0015 / (away * pixel);
  TownLight town;
  town.radius = max(wide, 0.9);
  float share = min(wide / town.radius, 1.0);
  town.light = color * (4.0 * all * brightness * night_share(dot(up, scene.sun)) * facing * share * share);
  return town;
}
