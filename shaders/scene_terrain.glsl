// The parameters of the height function, from those of the scene.
#include "scene_block.glsl"
#include "lib/heights.glsl"

Terrain scene_terrain() {
  Terrain t;
  t.height = terrain_height;
  t.frequency = terrain_frequency;
  t.octaves = terrain_octaves;
  t.persistence = terrain_persistence;
  t.lacunarity = terrain_lacunarity;
  t.power = terrain_power;
  t.ridged = terrain_ridged != 0;
  t.sharpness = terrain_ridge_sharpness;
  t.seed = uint(planet_seed);
  t.ranges.part = terrain_ranges;
  t.ranges.low = terrain_foothills;
  t.ranges.first = terrain_range_layer;
  t.craters.depth = terrain_craters;
  t.craters.frequency = terrain_crater_frequency;
  t.craters.sizes = terrain_crater_sizes;
  t.craters.seed = uint(planet_seed);
  t.ice.sea = water_level;
  t.ice.sine = polar_sine(water_ice_latitude);
  t.ice.thickness = ice_thickness(terrain_height);
  t.ice.seed = uint(planet_seed);
  return t;
}
