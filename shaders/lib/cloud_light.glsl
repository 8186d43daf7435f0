// Clouds as they are lit and as they shade what lies below them. Lengths in planet radii.
#include "lib/clouds.glsl"
#include "lib/light.glsl"

struct Clouds {
  float height;     // of their shell over the unit sphere
  float thickness;  // of the layer
  float coverage;   // part of the sky that is covered, 0..1
  float softness;   // 0..1
  float density;    // opacity where they are thickest, 0..1
  float shadow;     // how dark they shade themselves and the ground, 0..1
  vec3 color;
};

// What there is of clouds at a place of their shell.
struct CloudAt {
  vec3 up;      // unit, from the planet's centre to the place
  float climb;  // sine of the sun's height
  vec3 toward;  // the sun's direction along the shell
  float reach;  // how far along it the light has come that arrives through one depth of the layer, rad
  float noise;  // that clouds are made from
  float rise;   // by how much more there is of it where that light has entered
};

// Without noise. up: unit.
CloudAt cloud_place(vec3 up, vec3 sun, Clouds clouds) {
  CloudAt at;
  at.up = up;
  at.climb = dot(up, sun);
  at.toward = sun - at.climb * up;
  at.reach = clouds.thickness / max(at.climb, 0.2);
  at.noise = 0.0;
  at.rise = 0.0;
  return at;
}

// Where the light has entered that arrives at a place of the shell, unit.
vec3 cloud_entry(CloudAt at) {
  return normalize(at.up + at.reach * at.toward);
}

// The cloud as seen from the eye, through the air between. offset: from the eye to the cloud.
Veil cloud_veil(CloudAt cloud, vec3 offset, Clouds clouds, SceneLight scene) {
  vec3 to_eye = -normalize(offset);
  float thickness = cloud_thickness(cloud.noise, clouds.coverage, clouds.softness);
  // The cloud is as high as it is thick: what rises towards the sun shades what lies behind it.
  float from_below = dot(cloud.up, to_eye) < 0.0 ? 1.5 * thickness : 0.0;
  float depth = max(0.7 + 10.0 * cloud.rise, 0.0) + from_below;
  float self_shade = mix(1.0, exp(-depth) * 1.25, clouds.shadow);
  LightAt at = light_at(cloud.up, clouds.height, scene);
  vec3 sunlit = at.sun * (wrap_diffuse(cloud.climb, 0.25) * self_shade);
  vec3 light = clouds.color * (sunlit + 1.6 * skylight(at, cloud.up, scene)) * 0.5;
  // A shell seen along its edge would end in a line.
  float edge = smoothstep(0.0, 0.16, abs(dot(cloud.up, to_eye)));
  Veil veil;
  veil.opacity = clouds.density * thickness * edge;
  veil.light = through_air(light, at, offset, scene) * veil.opacity;
  return veil;
}

// How far it is along a ray (unit) from a place under the shell to it, held to a level ray where it sinks; below 0: the place lies
// over it.
float way_to_clouds(vec3 place, vec3 ray, Clouds clouds) {
  float climb = dot(place, ray);
  float reach = (1.0 + clouds.height) * (1.0 + clouds.height) - dot(place, place);
  return reach / (max(climb, 0.0) + sqrt(max(climb * climb + reach, 1.0e-8)));
}

// Where the sunlight of a place has passed the shell, unit.
vec3 cloud_before_sun(vec3 place, vec3 sun, Clouds clouds) {
  return normalize(place + way_to_clouds(place, sun, clouds) * sun);
}

// Part of the sunlight that the clouds leave at a place; all of it above them. thickness: of the cloud before the sun.
float cloud_shade(vec3 place, float thickness, Clouds clouds) {
  float reach = (1.0 + clouds.height) * (1.0 + clouds.height) - dot(place, place);
  return 1.0 - 0.85 * step(0.0, reach) * clouds.shadow * clouds.density * thickness;
}
