// What meshes and maps are too coarse for.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "measure/limits.hpp"
#include "measure/trials.hpp"
#include "planet/icosphere.hpp"
#include "planet/terrain.hpp"
#include "planet/waves.hpp"
#include "scene/choices.hpp"

namespace terrella {
namespace {

using Height = std::function<double(const glm::dvec3& direction)>;

// Part of a relief that is missed at places all over a sphere, root of the mean square.
double missed_relief(const Height& height_at, const Height& drawn_at) {
  std::mt19937 random(5U);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  constexpr int places = 2000;
  double sum = 0.0, squares = 0.0, missed = 0.0;
  for (int i = 0; i < places; ++i) {
    const double z = 2.0 * uniform() - 1.0, turn = 2.0 * std::numbers::pi * uniform(), r = std::sqrt(1.0 - z * z);
    const glm::dvec3 direction(r * std::cos(turn), r * std::sin(turn), z);
    const double height = height_at(direction);
    sum += height;
    squares += height * height;
    missed += std::pow(height - drawn_at(direction), 2);
  }
  return std::sqrt(missed / (squares - sum * sum / places));
}

double missed_hills(const Scene& scene) {
  const f32::Terrain terrain = terrain_of(scene);
  const int level = ground_level(scene);
  return missed_relief(
      [&](const glm::dvec3& direction) { return ground_radius(terrain, direction, 1e-7) - 1.0; },
      [&](const glm::dvec3& direction) { return drawn_ground_radius(terrain, direction, level) - 1.0; });
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
      [](const Scene& scene, const View&) { return missed_hills(scene); });
}

// Of waves as they run where they came from and where they are to go, and of what the corners of flat triangles carry
// of them.
double missed_waves(const Scene& scene, const View& view) {
  const Sea sea = make_sea(scene, view.seconds);
  const int level = needs_of(scene, view, pose_of(scene, view)).water_level;
  const auto height = [&](const glm::dvec3& direction, double footprint) {
    f64::WaveSum sum = f64::no_waves();
    const f64::Frame frame = f64::frame_at(direction);
    for (const f64::Wave& wave : sea.waves)
      f64::add_wave(sum, direction, frame, wave, f64::wave_weight(wave.wavenumber, footprint));
    return sum.height;
  };
  return missed_relief([&](const glm::dvec3& direction) { return height(direction, 0.0); },
                       [&](const glm::dvec3& direction) {
                         const IcospherePlace place = locate_on_icosphere(direction, level);
                         double drawn = 0.0;
                         for (std::size_t i = 0; i < place.corners.size(); ++i)
                           drawn +=
                               place.weights[static_cast<int>(i)] * height(place.corners[i], icosphere_edge(level));
                         return drawn;
                       });
}

Limit wave_lengths() {
  Scene start = bare_sea();
  start.waves.count = 1;
  start.water.model = choice("water.model", "waves");
  return follow(
      {"waves", "waves.length", "radii", "relief that the mesh misses, as a part", 0.2, {}}, start,
      {1.0, 0.3, 0.1, 0.08, 0.07, 0.05, 0.02, 1e-3},
      [](Scene& scene, View& view, double value) {
        view.height = 720;
        scene.waves.length = value;
        scene.waves.amplitude = 0.03 * value;
        scene.camera.altitude = scene.water.level + value;
      },
      missed_waves);
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
  start.terrain.model = start.water.model = start.air.model = start.stars.model = no_model;
  start.clouds.octaves = 1;
  start.clouds.warp = start.clouds.swirl = start.clouds.belts = start.clouds.speed = 0.0;
  start.quality.cloud_texels = 128;
  start.quality.cloud_texel_size = 64.0;  // so that pixels add nothing
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
  std::vector<Limit> limits = {terrain_frequencies(), wave_lengths()};
  if (extent != Extent::sample) limits.push_back(cloud_frequencies(renderer));
  return limits;
}

}  // namespace terrella
