// How sunlight, sky and air act on any place of a scene. Lengths in planet radii, the planet's ground being the unit sphere.
#include "lib/air.glsl"

// What lights a scene, seen from an eye.
struct SceneLight {
  vec3 eye;          // where it is
  float eye_height;  // over the unit sphere, as exactly as the eye is known
  vec3 sun;          // unit
  vec3 sunlight;     // linear colour times intensity
  float ambient;     // part of the sunlight that comes from all around
  vec3 sky_glow;     // that a low sun spreads over the sky of the eye (glow_of_sky); 0 outside of the air
  Air air;           // of density 0: there is none
};

// The light that reaches a place.
struct LightAt {
  vec3 up;   // unit, from the planet's centre to the place
  vec3 sun;  // sunlight before any cosine
  vec3 air;  // what the air around the place sends on
};

// Something before what is seen: its light, already weighted by its opacity, and what is behind shines through by
// 1 - opacity.
struct Veil {
  vec3 light;
  float opacity;
};

// Sunlight is reddened where the sun stands low, and gone in the planet's own shadow. height: over the unit sphere.
LightAt light_at(vec3 up, float height, SceneLight scene) {
  LightAt at;
  at.up = up;
  float climb = dot(up, scene.sun);
  float dip = sqrt(2.0 * max(height, 0.0));
  float risen = smoothstep(-0.02 - dip, 0.10, climb);
  float low = 1.0 - smoothstep(0.0, 0.30, climb);
  vec3 reddened = mix(vec3(1.0), scene.air.dusk * 1.1, 0.62 * scene.air.density * low * low);
  at.sun = scene.sunlight * reddened * risen;
  at.air = scene.sunlight * air_light(up, scene.sun, scene.air);
  return at;
}

// Light from the sky and from all around on a surface that faces along normal.
vec3 skylight(LightAt at, vec3 normal, SceneLight scene) {
  float open = 0.5 + 0.5 * dot(normal, at.up);
  return at.air * (0.22 * scene.air.density * open) + scene.sunlight * scene.ambient * vec3(0.32, 0.40, 0.62);
}

// Light of the air itself as it is seen along a ray, at full opacity.
vec3 light_of_air(LightAt at, vec3 ray, SceneLight scene) {
  return 0.55 * at.air + wide_glow(dot(ray, scene.sun)) * scene.sky_glow;
}

// Light of the sky where one looks along a ray from the place.
vec3 sky_along(LightAt at, vec3 ray, SceneLight scene) {
  float level = 1.0 - max(dot(at.up, ray), 0.0);
  float seen = scene.air.density * mix(0.22, 1.0, level * level * level);
  return seen * light_of_air(at, ray, scene);
}

// The light of a surface as it arrives at the eye through the air before it. offset: from the eye to the surface.
vec3 through_air(vec3 light, LightAt at, vec3 offset, SceneLight scene) {
  float distance_to = length(offset);
  vec3 ray = offset / distance_to;
  AirPath path = air_path(scene.eye, ray, scene.air.top);
  float before = clamp(distance_to - path.enter, 0.0, path.leave - path.enter);
  float whole = air_opacity(path.cosine, scene.air);
  return mix(light, light_of_air(at, ray, scene), air_opacity_before(whole, path.cosine, before, scene.air.top));
}

// The air along a ray that meets nothing but the sky. ray: unit.
Veil air_before_sky(vec3 ray, SceneLight scene) {
  Air air = scene.air;
  AirPath path = air_path(scene.eye, ray, air.top);
  float way = path.leave - path.enter;
  float opacity = air_opacity_before(air_opacity(path.cosine, air), path.cosine, way, air.top);
  // Those who leave the air leave the least of it, which is all around them, little by little.
  float thickness = air.top - 1.0;
  float overhead = 0.10 * air.density * (1.0 - smoothstep(0.9 * thickness, thickness, scene.eye_height));
  opacity = clamp(opacity + overhead * (1.0 - opacity), 0.0, 1.0);
  // Lit where the ray comes nearest to the planet.
  vec3 nearest = scene.eye + ray * clamp(-dot(scene.eye, ray), path.enter, path.leave);
  vec3 light = scene.sunlight * 0.55 * air_light(normalize(nearest), scene.sun, air);
  float toward = dot(ray, scene.sun);
  light += scene.sky_glow * (wide_glow(toward) + pow(max(toward, 0.0), 60.0));
  Veil veil;
  veil.light = light * opacity;
  veil.opacity = opacity;
  return veil;
}

// Part of the light from infinity that reaches the eye, 0..1: what the planet's air leaves of it, and from within the air
// the daylight. direction: unit, away from the eye.
float sky_shown(vec3 direction, SceneLight scene) {
  vec3 up = normalize(scene.eye);
  float thickness = scene.air.top - 1.0;
  float within = 1.0 - smoothstep(0.9 * thickness, thickness, scene.eye_height);
  float by_daylight = exp(-6.0 * scene.air.density * smoothstep(-0.25, 0.1, dot(up, scene.sun))) *
                      smoothstep(0.0, 0.3, dot(up, direction));
  // The thinnest air hides nothing.
  float hides = min(4.0 * scene.air.density, 1.0);
  return mix(1.0, mix(sky_past_air(scene.eye, direction, scene.air.top), by_daylight, within), hides);
}

// Sunlight as it comes to the eye: through the air around the eye, or, from outside, through that along the planet's limb.
vec3 sunlight_at_eye(SceneLight scene) {
  float thickness = scene.air.top - 1.0;
  float within = 1.0 - smoothstep(0.5 * thickness, thickness, scene.eye_height);
  float along = dot(scene.eye, scene.sun);
  float lowest = length(scene.eye - along * scene.sun) - 1.0;
  float grazing = along < 0.0 ? 1.0 - clamp(lowest / thickness, 0.0, 1.0) : 0.0;
  vec3 past_limb = scene.sunlight * mix(vec3(1.0), scene.air.dusk, 0.8 * scene.air.density * grazing * grazing);
  return mix(past_limb, light_at(normalize(scene.eye), scene.eye_height, scene).sun, within);
}
