// What jitters or swims under a camera that hardly moves.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/text.hpp"
#include "measure/limits.hpp"
#include "measure/stability.hpp"
#include "measure/trials.hpp"
#include "scene/choices.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

// Where nothing could be measured, nothing is known to hold.
double told(const Jitter& jitter, double pixels) {
  return jitter.measured > 0.0 ? pixels : std::numeric_limits<double>::infinity();
}

// Of what is smooth.
Error jitter(Renderer& renderer, Channel channel) {
  return [&renderer, channel](const Scene& scene, const View& view) {
    const Jitter found = jitter_of(renderer, scene, view, channel);
    return told(found, found.largest);
  };
}

// Of hills, where a pixel at an edge may show the one before the edge and then the one behind it.
Error jitter_of_hills(Renderer& renderer) {
  return [&renderer](const Scene& scene, const View& view) {
    const Jitter found = jitter_of(renderer, scene, view, Channel::distance);
    return told(found, found.nearly_all);
  };
}

constexpr const char* outline_error = "most that a surface jitters on the screen, px";
constexpr const char* hills_error = "that 99 of 100 pixels of hills jitter less than, px";
constexpr const char* swim_error = "most that what the water carries swims on the screen, px";
constexpr double outline_demand = 0.01, swim_demand = 0.1;

// So that the planet fills the picture, from far away as well.
double filling_fov(double altitude_in_radii) {
  return std::clamp(2.0 * std::atan(1.6 / altitude_in_radii) * 180.0 / std::numbers::pi, 1.0, 45.0);
}

Limit ground_from_all_heights(Renderer& renderer, double radius) {
  const Scene start = scaled(bare_ground("moon"), radius);
  return follow(
      {"ground", "camera.altitude", text_of("radii, planet of ", radius, " m"), hills_error, outline_demand, {}}, start,
      {0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0},
      [&](Scene& scene, View&, double value) {
        scene.camera.altitude = value * radius;
        scene.camera.fov = filling_fov(value);
      },
      jitter_of_hills(renderer));
}

Limit sea_from_all_heights(Renderer& renderer) {
  Scene start = bare_sea();
  start.water.ripples = 0.0;
  start.camera.pitch = -60.0;
  return follow(
      {"sea", "camera.altitude", "radii over the sea", outline_error, outline_demand, {}}, start,
      {1e-4, 1e-3, 1e-2, 0.1, 1.0},
      [](Scene& scene, View&, double value) { scene.camera.altitude = scene.water.level + 1e-9 + value; },
      jitter(renderer, Channel::distance));
}

Limit fields_of_view(Renderer& renderer) {
  return follow(
      {"ground", "camera.fov", "deg, 720 rows", hills_error, outline_demand, {}}, bare_ground("moon"),
      {1.0, 5.0, 20.0, 60.0, 120.0, 170.0},
      [](Scene& scene, View& view, double value) {
        view.width = 16;
        view.height = 720;
        scene.camera.fov = value;
        scene.camera.altitude = 1.6 / std::tan(0.5 * value * std::numbers::pi / 180.0);
      },
      jitter_of_hills(renderer));
}

// Over the poles the camera is moved along a meridian.
Limit latitudes(Renderer& renderer) {
  return follow(
      {"ground", "camera.latitude", "deg", hills_error, outline_demand, {}}, bare_ground("moon"),
      {-90.0, -89.9999, -45.0, 0.0, 45.0, 89.9999, 90.0},
      [](Scene& scene, View&, double value) { scene.camera.latitude = value; }, jitter_of_hills(renderer));
}

Limit waves_at_all_times(Renderer& renderer) {
  Scene start = usual(find_preset("storm")->scene);
  start.clouds.model = no_model;
  start.camera.altitude = 0.3;
  return follow(
      {"waves", "time", "s", hills_error, outline_demand, {}}, start, {0.0, 1.0, 1e3, 1e6, 1e9},
      [](Scene&, View& view, double value) { view.seconds = value; }, jitter_of_hills(renderer));
}

Limit terrain_heights(Renderer& renderer) {
  Scene start = bare_ground("alps");
  start.camera.pitch = -60.0;
  return follow(
      {"ground", "terrain.height", "m, planet of 1 m", hills_error, outline_demand, {}}, start,
      {0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0},
      [](Scene& scene, View&, double value) {
        scene.terrain.height = value;
        scene.camera.altitude = 1.0 + value;
      },
      jitter_of_hills(renderer));
}

Limit water_levels(Renderer& renderer) {
  Scene start = bare_sea();
  start.water.ripples = 0.0;
  start.camera.pitch = -60.0;
  return follow(
      {"sea", "water.level", "m, planet of 1 m", outline_error, outline_demand, {}}, start,
      {0.01, 1.0, 10.0, 100.0, 1e4, 1e6},
      [](Scene& scene, View&, double value) {
        scene.water.level = value;
        scene.camera.altitude = value + 0.01 * (1.0 + value);
      },
      jitter(renderer, Channel::distance));
}

Limit ripples_from_low(Renderer& renderer) {
  return follow(
      {"ripples", "camera.altitude", "radii over the sea", swim_error, swim_demand, {}}, bare_sea(),
      {1.01e-4, 2e-4, 5e-4, 1e-3, 1e-2, 0.1},
      [](Scene& scene, View& view, double value) {
        view.height = 162;  // fine enough that the nearest leave the range
        scene.camera.altitude = scene.water.level + value;
      },
      jitter(renderer, Channel::normal));
}

Limit waves_from_low(Renderer& renderer) {
  Scene start = bare_sea();
  start.waves.count = 1;
  start.water.model = choice("water.model", "waves");
  return follow(
      {"waves", "camera.altitude", "radii over the sea", swim_error, swim_demand, {}}, start,
      {2e-4, 5e-4, 1e-3, 3e-3, 1e-2, 0.1},
      [](Scene& scene, View&, double value) {
        scene.waves.length = value / 5.0;
        scene.waves.amplitude = 0.01 * scene.waves.length;
        scene.camera.altitude = scene.water.level + scene.waves.amplitude + value;
      },
      jitter(renderer, Channel::normal));
}

}  // namespace

std::vector<Limit> limits_of_stillness(Renderer& renderer, Extent extent) {
  if (extent == Extent::sample) return {};
  return {ground_from_all_heights(renderer, 1.0),
          ground_from_all_heights(renderer, 1e8),
          latitudes(renderer),
          sea_from_all_heights(renderer),
          waves_at_all_times(renderer),
          fields_of_view(renderer),
          terrain_heights(renderer),
          water_levels(renderer),
          ripples_from_low(renderer),
          waves_from_low(renderer)};
}

}  // namespace terrella
