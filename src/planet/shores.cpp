#include "planet/shores.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "planet/materials.hpp"
#include "planet/needs.hpp"
#include "planet/spiral.hpp"
#include "planet/terrain.hpp"

namespace terrella {
namespace {

constexpr double steepness_of_no_shore = 0.05, least_steepness = 0.005;

double found_shore_slope(const Scene& scene, double footprint) {
  constexpr int places = 96;
  constexpr std::size_t enough = 15;
  f64::Terrain terrain = exact_terrain_of(scene);
  terrain.ice.sine = f64::polar_sine(90.0);  // no ice, whose edges are no shores
  const double level = water_level(scene) / scene.planet.radius;
  const auto ground_at = [&](const glm::dvec3& direction) {
    f64::Height height;
    heights_at(direction, terrain, {&footprint, 1}, {&height, 1});
    return height;
  };
  std::vector<double> slopes;
  glm::dvec3 last = spiral_direction(0, places);
  bool last_is_land = ground_at(last).value > level;
  for (int i = 1; i < places && slopes.size() < enough; ++i) {
    const glm::dvec3 here = spiral_direction(i, places);
    const bool is_land = ground_at(here).value > level;
    if (is_land != last_is_land) {
      glm::dvec3 land = is_land ? here : last, sea = is_land ? last : here, shore = land;
      f64::Height found{};
      for (int step = 0; step < 20; ++step) {
        shore = glm::normalize(land + sea);
        found = ground_at(shore);
        (found.value > level ? land : sea) = shore;
      }
      slopes.push_back(glm::length(found.gradient - glm::dot(found.gradient, shore) * shore));
    }
    last = here;
    last_is_land = is_land;
  }
  if (slopes.empty()) return steepness_of_no_shore;
  const auto median = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
  std::nth_element(slopes.begin(), median, slopes.end());
  return std::max(*median, least_steepness);
}

// What found_shore_slope depends on, and what it was last: each frame asks for it.
struct Remembered {
  decltype(Scene::planet) planet;
  decltype(Scene::terrain) terrain;
  double level = -1.0, footprint = 0.0, slope = 0.0;
};

}  // namespace

double shore_slope(const Scene& scene, double footprint) {
  if (!has_ground(scene) || !has_water(scene)) return steepness_of_no_shore;
  static thread_local Remembered last;
  if (last.level != scene.water.level || last.footprint != footprint || !(last.terrain == scene.terrain) ||
      !(last.planet == scene.planet))
    last = {scene.planet, scene.terrain, scene.water.level, footprint, found_shore_slope(scene, footprint)};
  return last.slope;
}

double hiding_depth(const Scene& scene, const Sea& sea) {
  constexpr double thousandth = 6.9;
  const glm::dvec3 extinction = water_look_of(scene).extinction;
  const double clearest = std::min({extinction.x, extinction.y, extinction.z});
  // A quarter of its length deep, a wave is 5 % shorter than where nothing is felt.
  const double felt = sea.short_waves.empty() ? 0.0 : 0.5 * std::numbers::pi / sea.short_waves.front().wavenumber;
  return std::max({thousandth / std::max(clearest, 1e-12), whole_wave_depth(sea), felt});
}

f64::Shore shore_of(const Scene& scene, const Sea& sea) {
  return {0.0, {0.0, 0.0}, 1.0 / shore_slope(scene, longest_wave(sea)), hiding_depth(scene, sea)};
}

double wet_height(const Scene& scene, const Sea& sea) {
  const bool run_up = has_water(scene) && !sea.is_calm() && has_nodes(ground_technique(scene));
  return run_up ? f64::run_up * whole_wave_depth(sea) : 0.0;
}

int foam_layer(const Scene& scene, const Sea& sea) {
  constexpr double highest_frequency = 0.5 / finest_footprint;
  const auto& terrain = scene.terrain;
  double frequency = terrain.frequency;
  for (int i = 0; i + 1 < terrain.octaves && frequency * terrain.lacunarity < highest_frequency; ++i) {
    if (frequency * whole_wave_depth(sea) > 3.0) return i;
    frequency *= terrain.lacunarity;
  }
  return -1;
}

}  // namespace terrella
