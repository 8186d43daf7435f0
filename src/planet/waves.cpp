#include "planet/waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "planet/needs.hpp"
#include "planet/real_size.hpp"
#include "planet/wind_sea.hpp"
#include "scene/choices.hpp"

namespace terrella {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

// Just under the sum at which the surface folds.
constexpr double most_pinch = 0.95;

// How much stronger waves are together where three regions meet.
constexpr double meeting_regions = std::numbers::sqrt3;

// Six standard deviations of a sum of waves of random phases. squares: sum of those of their sizes.
double unlikely(double squares) { return 6.0 * std::sqrt(0.5 * squares); }

// Waves with more of them in a radian of arc (times a turn) are short, over a ground of nodes: single precision knows
// the phases of others from the direction of a place, and a miniature is never seen from so near.
constexpr double longest_short = 5000.0;

// Uniform in 0..1, the same on every machine (the standard's distributions are not).
double uniform(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }

glm::dvec3 any_direction(std::mt19937& random) {
  const double z = 2.0 * uniform(random) - 1.0;
  const double angle = turn * uniform(random);
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {r * std::cos(angle), r * std::sin(angle), z};
}

// A wave as the scene asks for it, before it has its place. SI units, but amplitudes as parts of one another.
struct AskedWave {
  double length, amplitude;
  double frequency;  // rad/s
  glm::dvec3 origin;
  double heading;  // of its way through the middle of a region, from that of the wind, rad
  double start;    // phase, rad
};

glm::dvec3 origin_between(const glm::dvec3& main, const glm::dvec3& own, double spread) {
  const glm::dvec3 origin = main * (1.0 - spread) + own * spread;
  return glm::length(origin) > 1e-3 ? glm::normalize(origin) : own;
}

std::vector<AskedWave> free_waves(const Scene& scene, int count, std::mt19937& random) {
  const auto& from = scene.waves;
  const glm::dvec3 main_origin = any_direction(random);
  std::vector<AskedWave> waves;
  for (int i = 0; i < count; ++i) {
    const double rank = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
    const double part = std::pow(0.2, rank) * (i == 0 ? 1.0 : 0.85 + 0.3 * uniform(random));
    const glm::dvec3 own = any_direction(random);
    AskedWave wave;
    wave.length = part * from.length;
    wave.amplitude = part;
    wave.frequency = turn / wave.length * from.speed * std::sqrt(part);
    wave.origin = origin_between(main_origin, own, from.spread);
    wave.heading = from.spread * std::atan2(own.y, own.x);
    wave.start = turn * uniform(random);
    waves.push_back(wave);
  }
  // In pixels those that are too short for one are the last.
  std::sort(waves.begin(), waves.end(), [](const auto& a, const auto& b) { return a.length > b.length; });
  return waves;
}

std::vector<AskedWave> waves_of_wind(const Scene& scene, int count, std::mt19937& random) {
  const auto& from = scene.waves;
  const double fetch = std::min(from.fetch, std::numbers::pi * scene.planet.radius);
  const glm::dvec3 main_origin = any_direction(random);
  std::vector<double> jitter;
  for (int i = 0; i < count; ++i) jitter.push_back(uniform(random));
  std::vector<AskedWave> waves;
  // Angles of neighbours in length differ as those of a sunflower's seeds.
  double part = uniform(random);
  for (const WindWave& raised : wind_waves(WindSpectrum(from.wind, fetch), from.shortest, jitter)) {
    part += std::numbers::phi;
    AskedWave wave;
    wave.length = raised.length;
    wave.amplitude = raised.amplitude;
    wave.frequency = deep_frequency(raised.length);
    wave.origin = origin_between(main_origin, any_direction(random), from.spread);
    wave.heading = 2.0 * from.spread * angle_of_part(part - std::floor(part));
    wave.start = turn * uniform(random);
    waves.push_back(wave);
  }
  return waves;
}

// Axes in the middle of a region: where it lies, and where north is there, which at the poles goes on along longitude
// 0.
glm::dvec3 middle_of(int region) {
  glm::dvec3 middle(0.0);
  middle[region / 2] = region % 2 == 0 ? 1.0 : -1.0;
  return middle;
}

glm::dvec3 north_of(int region) {
  const glm::dvec3 middle = middle_of(region);
  return region < 4 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(-middle.z, 0.0, 0.0);
}

double reduced(double phase) { return std::remainder(phase, turn); }

// A scene's sea at time 0, and how fast its waves turn (rad/s).
struct SeaShape {
  Sea sea;
  std::vector<double> frequencies, short_frequencies;
};

SeaShape shape_of(const Scene& scene, bool has_regions) {
  const auto& from = scene.waves;
  const bool wind = is_of_wind(scene);
  SeaShape shape;
  Sea& sea = shape.sea;
  std::mt19937 random(static_cast<std::mt19937::result_type>(from.seed) * 2654435761U + 17U);
  const double radius = scene.planet.radius;
  const int count = has_regions ? from.count : std::min(from.count, most_long_waves);
  const std::vector<AskedWave> asked = wind ? waves_of_wind(scene, count, random) : free_waves(scene, count, random);
  double squares = 0.0;
  for (const AskedWave& wave : asked) squares += wave.amplitude * wave.amplitude;
  sea.amplitude = (wind ? std::sqrt(squares) : from.amplitude) / radius;
  const double scale = sea.amplitude / std::sqrt(squares);

  Together slopes, short_heights, short_slopes;
  double long_heights = 0.0;
  for (const AskedWave& wave : asked) {
    const double amplitude = scale * wave.amplitude, wavenumber = turn * radius / wave.length;
    slopes.add(amplitude * wavenumber);
    if (!has_regions || wavenumber < longest_short) {
      sea.waves.push_back({wave.origin, amplitude, wavenumber, wave.start, 0.0});
      shape.frequencies.push_back(wave.frequency);
      long_heights += amplitude;
      continue;
    }
    short_heights.add(amplitude);
    short_slopes.add(amplitude * wavenumber);
    const double heading = glm::radians(from.direction) + std::numbers::pi + wave.heading;
    RegionalWave regional = {amplitude, wavenumber, 0.0, heading, {}};
    for (double& phase : regional.phases) phase = turn * uniform(random);
    sea.short_waves.push_back(regional);
    shape.short_frequencies.push_back(wave.frequency);
  }

  // So many waves as a wind raises never meet, so different are their lengths.
  const double most_slope = slopes.sum + (meeting_regions - 1.0) * short_slopes.sum;
  const double steepest = wind ? std::min(most_slope, unlikely(slopes.squares)) : most_slope;
  sea.steepness = std::min(from.steepness, most_pinch / std::max(steepest, 1e-12));
  sea.held = sea.steepness < from.steepness;
  for (f64::Wave& wave : sea.waves) wave.pinch = sea.steepness * wave.amplitude;
  for (RegionalWave& wave : sea.short_waves) wave.pinch = sea.steepness * wave.amplitude;
  sea.highest = long_heights + short_heights.most();
  sea.slope_variance = 0.5 * slopes.squares;
  sea.breaking.choppiness = sea.steepness;
  if (wind) {
    // So that as much is white as that wind whitens: the Jacobian's deviation is about that of the slopes' sum.
    constexpr double softness = 0.3;
    const double with_what_is_left = 1.0 + f64::left_after_quarter + f64::left_after_half;
    const double deviation = std::max(sea.steepness * std::sqrt(sea.slope_variance), 1e-6);
    sea.breaking.fold =
        1.0 + deviations_of(whitecaps(from.wind) / with_what_is_left) * deviation * std::hypot(1.0, softness);
    sea.breaking.softness = softness * deviation;
  }
  return shape;
}

// What shape_of a scene depends on, and what it was last: a frame asks for its sea several times.
struct Remembered {
  decltype(Scene::waves) waves;
  double radius = 0.0;
  bool has_regions = false;
  SeaShape shape;
};

}  // namespace

bool is_of_wind(const Scene& scene) { return scene.waves.spectrum == choice("waves.spectrum", "wind"); }

bool waves_run(const Scene& scene) { return is_of_wind(scene) || scene.waves.speed > 0.0; }

Sea make_sea(const Scene& scene, double seconds) {
  const auto& from = scene.waves;
  if (scene.water.model == choice("water.model", "calm") || from.count == 0 ||
      (!is_of_wind(scene) && from.amplitude <= 0.0))
    return {};
  static thread_local Remembered last;
  const bool has_regions = has_real_size && has_nodes(ground_technique(scene));
  if (!(last.waves == from) || last.radius != scene.planet.radius || last.has_regions != has_regions)
    last = {from, scene.planet.radius, has_regions, shape_of(scene, has_regions)};
  Sea sea = last.shape.sea;
  // Crests run away from their origins: phases fall with time.
  for (std::size_t i = 0; i < sea.waves.size(); ++i)
    sea.waves[i].phase = reduced(sea.waves[i].phase - std::fmod(last.shape.frequencies[i] * seconds, turn));
  for (std::size_t i = 0; i < sea.short_waves.size(); ++i) {
    const double turned = std::fmod(last.shape.short_frequencies[i] * seconds, turn);
    for (double& phase : sea.short_waves[i].phases) phase = reduced(phase - turned);
  }
  return sea;
}

f64::Wave in_region(const RegionalWave& wave, int region) {
  const glm::dvec3 north = north_of(region), east = glm::cross(north, middle_of(region));
  // A quarter of a great circle behind the region's middle.
  const glm::dvec3 origin = -std::cos(wave.heading) * north - std::sin(wave.heading) * east;
  return {origin, wave.amplitude, wave.wavenumber, wave.phases.at(static_cast<std::size_t>(region)), wave.pinch};
}

int drawn_long_waves(const Sea& sea) { return std::min(static_cast<int>(sea.waves.size()), most_long_waves); }

double Together::most() const { return std::min(meeting_regions * sum, unlikely(squares)); }

int region_around(int axis, const glm::dvec3& place) { return 2 * axis + (place[axis] < 0.0 ? 1 : 0); }

double longest_wave(const Sea& sea) {
  double least = sea.short_waves.empty() ? 0.0 : sea.short_waves.front().wavenumber;
  for (const f64::Wave& wave : sea.waves) least = least > 0.0 ? std::min(least, wave.wavenumber) : wave.wavenumber;
  return least > 0.0 ? turn / least : 0.0;
}

double whole_wave_depth(const Sea& sea) { return std::max(4.0 * sea.amplitude, 1.125 * std::max(sea.highest, 1e-9)); }

}  // namespace terrella
