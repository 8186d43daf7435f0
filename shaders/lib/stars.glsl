// Small lights in a picture: stars and towns.
#include "lib/light.glsl"
#include "lib/night.glsl"

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
