#include "measure/limits.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

#include <glm/geometric.hpp>

#include "base/text.hpp"
#include "measure/stability.hpp"
#include "planet/icosphere.hpp"
#include "planet/terrain.hpp"
#include "planet/validity.hpp"
#include "planet/waves.hpp"
#include "scene/choices.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

constexpr int none = 0;  // of every choice of a model

View small_view(double seconds = 0.0) {
  View view;
  view.width = 96;
  view.height = 54;
  view.seconds = seconds;
  return view;
}

// As fine as usual, but for the maps, which no distance shows.
Scene usual(Scene scene) {
  make_cheap(scene);
  scene.quality.pixel_error = 0.75;
  scene.camera.latitude = 40.0;
  return scene;
}

// A sea all over, without ice and clouds.
Scene bare_sea() {
  Scene scene = usual({});
  scene.terrain.model = scene.clouds.model = none;
  scene.water.ice_latitude = 90.0;
  return scene;
}

Scene bare_ground(const char* preset) {
  Scene scene = usual(find_preset(preset)->scene);
  scene.water.model = scene.clouds.model = none;
  return scene;
}

bool warned(const Scene& scene, const View& view, const std::string& path) {
  const Pose pose = pose_of(scene, view);
  const std::vector<Issue> issues = beyond_validity(scene, view, pose, needs_of(scene, view, pose));
  return std::any_of(issues.begin(), issues.end(), [&](const Issue& issue) { return issue.path == path; });
}

using Change = std::function<void(Scene&, View&, double)>;
using Error = std::function<double(const Scene&, const View&)>;

Limit follow(Limit limit, const Scene& start, const std::vector<double>& values, const Change& change,
             const Error& error) {
  for (const double value : values) {
    Scene scene = start;
    View view = small_view();
    change(scene, view, value);
    limit.points.push_back({value, error(scene, view), warned(scene, view, limit.path)});
  }
  return limit;
}

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
  start.clouds.model = none;
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

std::vector<float> light_of(Renderer& renderer, const Scene& scene, const View& view) {
  renderer.draw(scene, view, {Channel::color, Effort::complete, true});
  return renderer.read_light();
}

double spread(Pixels light) {
  double sum = 0.0, squares = 0.0;
  for (const float value : light) {
    sum += double{value};
    squares += double{value} * double{value};
  }
  const auto count = static_cast<double>(light.size());
  return std::sqrt(std::max(0.0, squares / count - sum * sum / count / count));
}

// Against a map four times as fine; 1 where even that shows nothing.
double missed_clouds(Renderer& renderer, Scene scene, const View& view) {
  const std::vector<float> drawn = light_of(renderer, scene, view);
  scene.quality.cloud_texels *= 4;
  const std::vector<float> finer = light_of(renderer, scene, view);
  const double contrast = spread(finer);
  return contrast > 1e-3 ? std::min(1.0, std::pow(10.0, -0.05 * light_psnr(drawn, finer)) / contrast) : 1.0;
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

// By how much (rad) a wave's step in a 64th of a second differs from its first one.
double step_error(const Scene& scene, double seconds) {
  constexpr double step = 1.0 / 64.0;  // exact, also after 30 years
  const auto phases = [&](double time) { return make_sea(scene, time).waves; };
  const auto first = phases(0.0), second = phases(step), third = phases(seconds), fourth = phases(seconds + step);
  double largest = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double at_first = double{second[i].phase} - double{first[i].phase};
    const double later = double{fourth[i].phase} - double{third[i].phase};
    largest = std::max(largest, std::abs(std::remainder(later - at_first, 2.0 * std::numbers::pi)));
  }
  return largest;
}

Limit wave_speeds() {
  Scene start = find_preset("storm")->scene;
  start.water.model = choice("water.model", "waves");
  return follow(
      {"waves", "waves.speed", "m/s, after 1e9 s", "step of a phase that differs from the first one, rad", 0.01, {}},
      start, {0.05, 1.0, 10.0, 1e3, 1e4, 1e6},
      [](Scene& scene, View& view, double value) {
        scene.waves.speed = value;
        view.seconds = 1e9;
      },
      [](const Scene& scene, const View& view) { return step_error(scene, view.seconds); });
}

Scene cheap(const char* preset) {
  Scene scene = find_preset(preset)->scene;
  make_cheap(scene);
  return scene;
}

Limit times(Renderer& renderer, const char* technique, const char* preset, Channel channel, double demand) {
  return follow(
      {technique, "time", "s", "change of the change from frame to frame, as a part of it", demand, {}}, cheap(preset),
      {0.0, 1.0, 1e3, 1e6, 1e9}, [](Scene&, View& view, double value) { view.seconds = value; },
      [&renderer, channel](const Scene& scene, const View& view) {
        return motion_at(renderer, scene, view, view.seconds, channel).unrest;
      });
}

Invariance scaled_by(Renderer& renderer, const char* preset, double factor, double bound) {
  const Scene scene = cheap(preset);
  const std::vector<float> as_it_is = light_of(renderer, scene, small_view());
  const std::vector<float> scaled_up = light_of(renderer, scaled(scene, factor), small_view());
  return {text_of(preset, ", all lengths times ", factor), "largest difference of light",
          largest_difference(as_it_is, scaled_up), bound};
}

// A sphere of calm water under air, in which nothing has a place of its own.
Scene plain_sphere() {
  Scene scene = bare_sea();
  scene.water.ripples = scene.stars.density = scene.stars.band = 0.0;
  scene.quality.pixel_error = 0.1;
  scene.camera.latitude = 0.0;
  scene.sun.latitude = -20.0;
  scene.sun.longitude = -40.0;
  return scene;
}

Invariance turned_by(Renderer& renderer, double longitude, double latitude, double bound) {
  Scene scene = plain_sphere();
  // Along one meridian, latitude turns both as well.
  if (latitude != 0.0) scene.sun.longitude = scene.camera.longitude;
  Scene turned = scene;
  turned.camera.longitude += longitude;
  turned.sun.longitude += longitude;
  turned.camera.latitude += latitude;
  turned.sun.latitude += latitude;
  const std::vector<float> as_it_is = light_of(renderer, scene, small_view());
  const std::vector<float> after = light_of(renderer, turned, small_view());
  return {text_of("sea under air, turned by ", longitude, " deg of longitude and ", latitude, " of latitude"),
          "root of the mean square difference of light", std::pow(10.0, -0.05 * light_psnr(as_it_is, after)), bound};
}

// How far hills move where the camera comes so near that the mesh of the ground is made with finer triangles. These may
// miss finer ones by 2.5 times quality.pixel_error (simplified, planet/icosphere_groups.hpp).
Invariance pops_by(Renderer& renderer, const char* preset) {
  const View view = small_view();
  Scene near = bare_ground(preset), far = near;
  near.camera.altitude = 0.6;
  far.camera.altitude = 0.8;
  const auto tolerance = [&](const Scene& scene) {
    return needs_of(scene, view, pose_of(scene, view)).ground_tolerance;
  };
  const double far_tolerance = tolerance(far);
  while (far.camera.altitude - near.camera.altitude > 1e-9) {
    Scene middle = near;
    middle.camera.altitude = 0.5 * (near.camera.altitude + far.camera.altitude);
    (tolerance(middle) == far_tolerance ? far : near) = middle;
  }
  const auto distances = [&](const Scene& scene) {
    renderer.draw(scene, view, {Channel::distance, Effort::complete, true});
    return renderer.read_light();
  };
  const std::vector<float> before = distances(far), after = distances(near);
  return {text_of(preset, ", as the camera comes nearer and the mesh finer"),
          "that 99 of 100 pixels of hills jump less than, px",
          jitter_between(before, after, view.width, view.height, 1, 1e-8).nearly_all, 2.5 * near.quality.pixel_error};
}

// After a million whole periods of all that moves in it.
Invariance repeats_after(Renderer& renderer, const char* what, const Scene& scene, double period, double bound) {
  constexpr double periods = 1e6;
  const std::vector<float> first = light_of(renderer, scene, small_view());
  const std::vector<float> later = light_of(renderer, scene, small_view(periods * period));
  const std::vector<float> between = light_of(renderer, scene, small_view(0.4 * period));
  const double apart = std::pow(10.0, -0.05 * light_psnr(first, later));
  return {text_of(what, ", after a million periods"), "difference of light, as a part of that after 0.4 periods",
          apart / std::pow(10.0, -0.05 * light_psnr(first, between)), bound};
}

std::vector<Invariance> repetitions(Renderer& renderer, double bound) {
  Scene still = cheap("temperate");
  still.clouds.speed = still.clouds.drift = still.water.ripple_speed = 0.0;
  Scene drifting = still, rippled = still, waving = still;
  drifting.clouds.drift = 0.5;
  rippled.water.ripple_speed = 1.2;
  rippled.camera.altitude = 0.3;
  waving.waves.count = 1;
  waving.camera.altitude = 0.5;
  return {repeats_after(renderer, "drifting clouds", drifting, 360.0 / drifting.clouds.drift, bound),
          repeats_after(renderer, "ripples", rippled, 2.0 * std::numbers::pi / rippled.water.ripple_speed, bound),
          repeats_after(renderer, "a wave", waving, waving.waves.length / waving.waves.speed, bound)};
}

// How alike in size the changes from frame to frame are: the larger one of two, as a multiple of the other.
Invariance moves_alike(Renderer& renderer, const char* preset, Channel channel, double bound) {
  const auto mean_change = [&](double from) {
    double sum = 0.0;
    for (int i = 0; i < 8; ++i) {  // far apart: one picture may show few clouds, the next one many
      sum += motion_at(renderer, cheap(preset), small_view(), from + 97.3 * i, channel).change;
    }
    return sum;
  };
  const double first = mean_change(0.0), late = mean_change(1e9);
  return {text_of(preset, ", after 1e9 s against the beginning"),
          "change from frame to frame, the larger as a multiple of the smaller",
          std::max(first, late) / std::max(1e-12, std::min(first, late)), bound};
}

}  // namespace

bool Limit::keeps_its_word() const { return worst_within() <= demand; }

double Limit::worst_within() const {
  double worst = 0.0;
  for (const LimitPoint& point : points) {
    if (point.warned) continue;
    worst = std::isnan(point.error) ? std::numeric_limits<double>::infinity() : std::max(worst, point.error);
  }
  return worst;
}

bool Limit::ends() const {
  return std::any_of(points.begin(), points.end(), [&](const LimitPoint& p) { return p.warned && p.error > demand; });
}

std::vector<Limit> measure_limits(Renderer& renderer, Extent extent) {
  std::vector<Limit> limits = {terrain_frequencies(), wave_speeds()};
  if (extent == Extent::sample) return limits;
  limits.push_back(ground_from_all_heights(renderer, 1.0));
  limits.push_back(ground_from_all_heights(renderer, 1e8));
  limits.push_back(latitudes(renderer));
  limits.push_back(sea_from_all_heights(renderer));
  limits.push_back(waves_at_all_times(renderer));
  limits.push_back(fields_of_view(renderer));
  limits.push_back(terrain_heights(renderer));
  limits.push_back(water_levels(renderer));
  limits.push_back(ripples_from_low(renderer));
  limits.push_back(waves_from_low(renderer));
  limits.push_back(cloud_frequencies(renderer));
  // Measured: clouds 0.003, waves 0.07.
  limits.push_back(times(renderer, "clouds", "temperate", Channel::color, 0.02));
  limits.push_back(times(renderer, "waves", "storm", Channel::normal, 0.15));
  return limits;
}

std::vector<Invariance> measure_invariances(Renderer& renderer, Extent extent) {
  std::vector<Invariance> found = {scaled_by(renderer, "temperate", 1048576.0, 0.0)};
  if (extent == Extent::sample) return found;
  for (const Preset& preset : presets()) {
    for (const double factor : {16.0, 67108864.0}) {
      found.push_back(scaled_by(renderer, preset.name.c_str(), factor, 0.0));
    }
  }
  // Factors that are no power of two may round the last bit of a length; measured: 0.
  found.push_back(scaled_by(renderer, "temperate", 6.371e6, 1e-3));
  found.push_back(scaled_by(renderer, "storm", 6.371e6, 1e-3));
  // The sea's triangles lie elsewhere; measured: 2.6e-4.
  found.push_back(turned_by(renderer, 72.0, 0.0, 1e-3));
  found.push_back(turned_by(renderer, 123.4, 0.0, 1e-3));
  found.push_back(turned_by(renderer, 0.0, 50.0, 1e-3));
  // Measured: 0.99, 0.94 and 0.
  for (const char* preset : {"moon", "alps", "mars"}) found.push_back(pops_by(renderer, preset));
  // Measured: 0, to the last bit.
  for (Invariance& repetition : repetitions(renderer, 1e-3)) found.push_back(std::move(repetition));
  // Measured: 1.03 and 1.001.
  found.push_back(moves_alike(renderer, "temperate", Channel::color, 1.3));
  found.push_back(moves_alike(renderer, "storm", Channel::normal, 1.3));
  return found;
}

}  // namespace terrella
