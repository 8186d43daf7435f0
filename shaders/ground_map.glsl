// The ground as its map holds it: used by the ground itself and by the water, at the bottom and along the shore.
#include "cloud_map.glsl"
#include "lib/ground.glsl"
#include "lib/heights.glsl"

// xyz: gradient of the height over the unit sphere, along the sphere, and upward the openness; w: height over the water,
// radii.
uniform samplerCube ground_map;

GroundAt ground_at(vec4 map, vec3 up) {
  GroundAt ground;
  ground.openness = dot(map.xyz, up);
  ground.gradient = map.xyz - ground.openness * up;
  ground.height = map.w;
  return ground;
}

// How high a unit of the mean of all layers stands, as the map tells it.
float map_rise(GroundAt ground) {
  return height_power_slope_at(ground.height + sea.x - 1.0, terrain_height, terrain_power);
}

// The mean of the normals of what is seen of the ground, whose gradient the map or the pixels know but for the layers that
// neither shows: they act as strongly as rise says. Those that no mesh carries are painted on it: of them as much is seen from behind as from before, so they
// are turned as far towards the eye as those that are seen would be. up, to_eye: unit; radius: of the place.
vec3 mean_normal(vec3 up, float radius, GroundAt ground, float rise, vec3 to_eye) {
  vec3 gradient = ground.gradient + mean_seen_slope(slopes.y * rise * rise, up, to_eye);
  return mean_normal_length(slopes.x * rise * rise) * slope_normal(up, radius, gradient);
}

Bands scene_bands() {
  Bands b;
  b.sand = terrain_sand_color.rgb;
  b.land = terrain_land_color.rgb;
  b.mountain = terrain_mountain_color.rgb;
  b.snow = terrain_snow_color.rgb;
  b.seabed = terrain_seabed_color.rgb;
  b.sea = water_depths.rgb;
  b.sand_height = terrain_sand_height;
  b.mountain_height = terrain_mountain_height;
  b.snow_height = terrain_snow_height;
  b.softness = terrain_softness;
  b.slope_rock = terrain_slope_rock;
  b.thinning = terrain_thinning;
  b.snow_sine = levels.x;
  b.hollows = terrain_hollows;
  return b;
}
