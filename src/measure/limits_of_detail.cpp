// What meshes and maps are too coarse for.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "measure/limits.hpp"
#include "measure/trials.hpp"
#include "planet/icosphere.hpp"
#include "planet/terrain.hpp"

namespace terrella {
namespace {

constexpr int none = 0;  // of every choice of a model

// Part of the relief of one layer of hills that flat triangles miss.
double missed_relief(const Scene& scene, int level) {
  const f32::Terrain terrain = terrain_of(scene);
  std::mt19937 random(5U);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  constexpr int places = 2000;
  double sum = 0.0, squares = 0.0, missed = 0.0;
  for (int i = 0; i < places; ++i) {
    const double z = 2.0 * uniform() - 1.0, turn = 2.0 * std::numbers::pi * uniform(), r = std::sqrt(1.0 - z * z);
    const glm::dvec3 direction(r * std::cos(turn), r * std::sin(turn), z);
    const double height = ground_radius(terrain, direction, 1e-7) - 1.0;
    sum += height;
    squares += height * height;
    missed += std::pow(height - (drawn_ground_radius(terrain, direction, level) - 1.0), 2);
  }
  return std::sqrt(missed / (squares - sum * sum / places));
}

Limit terrain_frequencies() {
  Scene start = bare_ground("temperate");
  start.terrain.octaves = 1;
  start.terrain.power = 1.0;
  return follow(
      {"ground", "terrain.frequency", "cells/radius", "relief that the mesh misses, as a part", 0.2, {}}, start,
      {0.5, 2.0, 8.0, 12.0, 16.0, 24.0, 100.0, 1e4},
      [](Scene& scene, View& view, double value) {
        view.height = 720;
        scene.terrain.frequency = value;
      },
      [](const Scene& scene, const View&) { return missed_relief(scene, ground_level(scene)); });
}

// Against a map four times as fine; 1 where even that shows nothing.
double missed_clouds(Renderer& renderer, Scene scene, const View& view) {
  const std::vector<float> drawn = light_of(renderer, scene, view);
  scene.quality.cloud_texels *= 4;
  const std::vector<float> finer = light_of(renderer, scene, view);
  const double contrast = contrast_of(finer);
  return contrast > 1e-3 ? std::min(1.0, mean_difference(drawn, finer) / contrast) : 1.0;
}

Limit cloud_frequencies(Renderer& renderer) {
  Scene start = usual({});
  start.terrain.model = start.water.model = start.air.model = start.stars.model = none;
  start.clouds.octaves = 1;
  start.clouds.warp = start.clouds.swirl = start.clouds.belts = start.clouds.speed = 0.0;
  start.quality.cloud_texels = 128;
  start.camera.fov = 8.0;
  return follow(
      {"clouds",
       "clouds.frequency",
       "cells/radius, 128 texels",
       "difference from a finer map, of its contrast",
       0.35,
       {}},
      start, {1.0, 3.0, 6.0, 12.0, 18.0, 30.0, 100.0},
      [](Scene& scene, View& view, double value) {
        view.width = view.height = 200;  // fine enough that the finest could be seen
        scene.clouds.frequency = value;
      },
      [&](const Scene& scene, const View& view) { return missed_clouds(renderer, scene, view); });
}

}  // namespace

std::vector<Limit> limits_of_detail(Renderer& renderer, Extent extent) {
  std::vector<Limit> limits = {terrain_frequencies()};
  if (extent != Extent::sample) limits.push_back(cloud_frequencies(renderer));
  return limits;
}

}  // namespace terrella
