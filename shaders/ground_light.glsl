// The ground as it is lit: used by the ground itself and by the water, at the bottom and along the shore.
#include "scene_light.glsl"
#include "lib/ground.glsl"
#include "lib/heights.glsl"

// xyz: gradient of the height over the unit sphere, along the sphere, and upward the openness; w: height over the water,
// radii.
uniform samplerCube ground_map;

// What the map holds of a place.
struct GroundAt {
  vec3 gradient;   // of the height over the unit sphere, along the sphere
  float openness;  // 0..1
  float height;    // over the water, radii
};

GroundAt ground_at(vec4 map, vec3 up) {
  GroundAt ground;
  ground.openness = dot(map.xyz, up);
  ground.gradient = map.xyz - ground.openness * up;
  ground.height = map.w;
  return ground;
}

Bands scene_bands() {
  Bands b;
  b.sand = terrain_sand_color.rgb;
  b.land = terrain_land_color.rgb;
  b.mountain = terrain_mountain_color.rgb;
  b.snow = terrain_snow_color.rgb;
  b.seabed = terrain_seabed_color.rgb;
  b.sea = water_color.rgb;
  b.sand_height = terrain_sand_height;
  b.mountain_height = terrain_mountain_height;
  b.snow_height = terrain_snow_height;
  b.softness = terrain_softness;
  b.slope_rock = terrain_slope_rock;
  b.thinning = terrain_thinning;
  b.snow_sine = levels.x;
  return b;
}

// Colour of the ground without light, darker in hollows. normal: of the ground.
vec3 ground_albedo(vec3 up, GroundAt ground, vec3 normal) {
  // The gradient's share along a fixed axis changes its sign from place to place: enough to break up lines.
  float variation = clamp(dot(ground.gradient, vec3(0.61, -0.52, 0.60)) * 0.8, -1.0, 1.0);
  vec3 color = ground_color(ground.height, 1.0 - dot(up, normal), up.z, variation, scene_bands());
  return color * mix(1.0, 0.5 + 0.8 * ground.openness, terrain_hollows);
}

// Light that the ground sends to the eye. shade: part of the sunlight left by the clouds.
vec3 ground_light(vec3 albedo, vec3 normal, LightAt at, float shade) {
  float cosine = max(dot(normal, sun_direction.xyz), 0.0);
  return albedo * (at.sun * (cosine * shade) + skylight(at, normal) * mix(0.7, 1.0, shade)) * 0.6;
}
