#include "planet/terrain.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "planet/icosphere.hpp"
#include "planet/octaves.hpp"

namespace terrella {

namespace {

// Terrain: f32::Terrain or f64::Terrain, whose numbers are Reals.
template <class Terrain, class Real>
Terrain made_terrain(const Scene& scene) {
  const auto& from = scene.terrain;
  const auto seed = static_cast<unsigned>(scene.planet.seed);
  Terrain terrain;
  terrain.height = static_cast<Real>(from.height / scene.planet.radius);
  terrain.frequency = static_cast<Real>(from.frequency);
  terrain.octaves = from.octaves;
  terrain.persistence = static_cast<Real>(from.persistence);
  terrain.lacunarity = static_cast<Real>(from.lacunarity);
  terrain.power = static_cast<Real>(from.power);
  terrain.ridged = from.ridged;
  terrain.sharpness = static_cast<Real>(from.ridge_sharpness);
  terrain.ranges.part = static_cast<Real>(from.ranges);
  terrain.ranges.low = static_cast<Real>(from.foothills);
  terrain.ranges.first = from.range_layer;
  terrain.seed = seed;
  terrain.craters.depth = static_cast<Real>(from.craters);
  terrain.craters.frequency = static_cast<Real>(from.crater_frequency);
  terrain.craters.sizes = from.crater_sizes;
  terrain.craters.seed = seed;
  terrain.ice.sea = static_cast<Real>(water_level(scene) / scene.planet.radius);
  terrain.ice.sine = static_cast<Real>(f64::polar_sine(scene.water.ice_latitude));
  terrain.ice.thickness = static_cast<Real>(f64::ice_thickness(from.height / scene.planet.radius));
  terrain.ice.seed = seed;
  if (const HeightMap* map = scene.terrain.map.map.get()) terrain.map = {map, map->serial()};
  return terrain;
}

}  // namespace

f64::Terrain exact_terrain_of(const Scene& scene) { return made_terrain<f64::Terrain, double>(scene); }

f32::Terrain terrain_of(const Scene& scene) { return made_terrain<f32::Terrain, float>(scene); }

// What reading a map costs, in evaluations of noise (measured).
constexpr int noise_per_map = 6;

int first_layer(const Scene& scene) {
  const SharedHeightMap& map = scene.terrain.map.map;
  return map ? f64::first_layer_beyond(map->texel(), exact_terrain_of(scene)) : 0;
}

int noise_per_height(const Scene& scene, double footprint) {
  const auto& terrain = scene.terrain;
  const int visible = visible_octaves(terrain.frequency, terrain.lacunarity, terrain.octaves, footprint);
  const int octaves = std::max(visible - first_layer(scene), 0) + (terrain.map.map ? noise_per_map : 0);
  return std::max(1, octaves + (terrain.craters > 0.0 ? 3 * terrain.crater_sizes : 0) + (has_ice(scene) ? 1 : 0));
}

double ground_radius(const f32::Terrain& terrain, const glm::dvec3& direction, double edge) {
  return 1.0 + double{f32::terrain_height_at(glm::vec3(direction), terrain, static_cast<float>(edge)).value};
}

double exact_ground_radius(const f64::Terrain& terrain, const glm::dvec3& direction, double edge) {
  return 1.0 + f64::terrain_height_at(direction, terrain, edge).value;
}

namespace {

void add_layers(const glm::dvec3& direction, const f64::Terrain& terrain, std::span<f64::HeightParts> parts) {
  double frequency = terrain.frequency;
  for (int i = 0; i < terrain.octaves; ++i) {
    f64::Noise noise = f64::no_noise();
    if (f64::layer_weight(frequency, parts.front().footprint) > 0.0)
      noise = f64::height_noise(direction, terrain, i, frequency);
    for (f64::HeightParts& each : parts) f64::add_height_layer(each, terrain, i, frequency, noise);
    frequency *= terrain.lacunarity;
  }
}

void dig_craters(const glm::dvec3& direction, const f64::Craters& craters, std::span<f64::HeightParts> parts) {
  double frequency = craters.frequency;
  for (int i = 0; i < craters.sizes; ++i) {
    if (f64::crater_weight(frequency, parts.front().footprint) <= 0.0) return;  // and so is that of all smaller ones
    double dug = 0.0;
    glm::dvec3 slope(0.0);
    f64::add_craters_of_size(direction, i, frequency, craters.seed, craters.depth, dug, slope);
    for (f64::HeightParts& each : parts) {
      const double shown = f64::crater_weight(frequency, each.footprint);
      each.dug += shown * dug;
      each.dug_gradient += shown * slope;
    }
    frequency *= f64::crater_step;
  }
}

}  // namespace

void heights_at(const glm::dvec3& direction, const f64::Terrain& terrain, std::span<const double> footprints,
                std::span<f64::Height> heights) {
  constexpr std::size_t most = 4;
  CHECK(footprints.size() <= most && heights.size() >= footprints.size(), footprints.size());
  if (terrain.map.map != nullptr) {
    for (std::size_t n = 0; n < footprints.size(); ++n)
      heights[n] = f64::terrain_height_at(direction, terrain, footprints[n]);
    return;
  }
  std::array<f64::HeightParts, most> room;
  const std::span parts = std::span(room).first(footprints.size());
  std::transform(footprints.begin(), footprints.end(), parts.begin(), f64::no_height);
  add_layers(direction, terrain, parts);
  if (terrain.craters.depth > 0.0) dig_craters(direction, terrain.craters, parts);
  for (std::size_t n = 0; n < parts.size(); ++n) heights[n] = f64::height_of(parts[n], direction, terrain);
}

double drawn_ground_radius(const f32::Terrain& terrain, const glm::dvec3& direction, int level) {
  const IcospherePlace place = locate_on_icosphere(direction, level);
  const double edge = icosphere_edge(level);
  glm::dvec3 point(0.0);
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3& corner = place.corners[static_cast<std::size_t>(i)];
    point += place.weights[i] * ground_radius(terrain, corner, edge) * corner;
  }
  // The weights belong to the triangle of unit corners; the displaced one is close enough for a length.
  return glm::length(point);
}

double unseen_slopes(const Scene& scene, double footprint) {
  const auto& terrain = scene.terrain;
  const double square = f64::noise_slope_square * f64::layer_slope_square(terrain.ridged, terrain.ridge_sharpness);
  double variance = 0.0, amplitude = 1.0, frequency = terrain.frequency;
  const int first = first_layer(scene);
  for (int i = 0; i < terrain.octaves; ++i) {
    const double shown = i < first ? 1.0 : f64::layer_weight(frequency, footprint);
    const double steepness = amplitude * frequency;
    variance += (1.0 - shown * shown) * steepness * steepness * square;
    amplitude *= terrain.persistence;
    frequency *= terrain.lacunarity;
  }
  const double total = f64::amplitude_sum(terrain.persistence, terrain.octaves);
  return total > 0.0 ? std::min(variance / (total * total), 1e6) : 0.0;
}

namespace {

// The same as unseen_heights of craters alone, as a variance of what they dig (radii).
double unseen_craters(const Scene& scene, double footprint, double finer) {
  constexpr double one_size = 0.0056;  // a deviation, in cells (tests/laws/craters_test.cpp)
  const auto& terrain = scene.terrain;
  double variance = 0.0, frequency = terrain.crater_frequency;
  for (int i = 0; i < terrain.crater_sizes; ++i) {
    const double unseen = f64::crater_weight(frequency, finer) - f64::crater_weight(frequency, footprint);
    variance += std::pow(unseen * terrain.craters * one_size / frequency, 2.0);
    frequency *= f64::crater_step;
  }
  return variance;
}

}  // namespace

double unseen_heights(const Scene& scene, double footprint, double finer) {
  // Deviations of noise and of its distance from 0 (tests/laws/noise_test.cpp and heights_test.cpp).
  constexpr double smooth_layer = 0.5 * 0.38, ridged_layer = 0.23;
  const auto& terrain = scene.terrain;
  const double layer = terrain.ridged ? ridged_layer : smooth_layer;
  double lost = 0.0, lost_ridges = 0.0, amplitude = 1.0, all_ridges = 0.0, frequency = terrain.frequency;
  const HeightMap* map = terrain.map.map.get();
  const int first = first_layer(scene);
  for (int i = 0; i < terrain.octaves; ++i) {
    const double unseen =
        i < first ? 0.0 : f64::layer_weight(frequency, finer) - f64::layer_weight(frequency, footprint);
    lost += std::pow(unseen * amplitude * layer, 2.0);
    if (i >= terrain.range_layer && map == nullptr) {
      lost_ridges += std::pow(unseen * amplitude * ridged_layer, 2.0);
      all_ridges += amplitude;
    }
    amplitude *= terrain.persistence;
    frequency *= terrain.lacunarity;
  }
  const double total = f64::amplitude_sum(terrain.persistence, terrain.octaves);
  const double height = terrain.height / scene.planet.radius;
  if (height > 0.0) lost += std::pow(std::max(total, 1.0) / height, 2.0) * unseen_craters(scene, footprint, finer);
  if (map != nullptr) {
    constexpr double high = 0.5;
    const double of_map = std::max(map->unseen_variance(footprint) - map->unseen_variance(finer), 0.0);
    const double rise = total > 0.0 ? f64::mapped_rise(high, terrain.power) / total : 0.0;
    return height * std::sqrt(of_map + rise * rise * lost);
  }
  if (total <= 0.0) return 0.0;
  constexpr double steep = 0.7;
  const double rise = (1.0 - terrain.ranges) * f64::height_power_slope(steep, height, terrain.power) / total;
  const double of_ranges = all_ridges > 0.0 ? 3.0 * steep * steep * terrain.ranges * height / all_ridges : 0.0;
  return std::hypot(rise * std::sqrt(lost), of_ranges * std::sqrt(lost_ridges));
}

bool has_relief(const Scene& scene) { return scene.terrain.octaves > 0 || scene.terrain.map.map; }

bool has_ground(const Scene& scene) { return scene.terrain.model != 0; }

bool has_ice(const Scene& scene) { return has_water(scene) && scene.water.ice_latitude < 90.0; }

bool has_water(const Scene& scene) { return scene.water.model != 0 && scene.water.level > 0.0; }

double water_level(const Scene& scene) { return has_water(scene) ? scene.water.level : 0.0; }

}  // namespace terrella
