#include "planet/waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

namespace terrella {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

// Just under the sum at which the surface folds.
constexpr double most_pinch = 0.95;

// Uniform in 0..1, the same on every machine (the standard's distributions are not).
double uniform(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }

glm::dvec3 any_direction(std::mt19937& random) {
  const double z = 2.0 * uniform(random) - 1.0;
  const double angle = turn * uniform(random);
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {r * std::cos(angle), r * std::sin(angle), z};
}

}  // namespace

Sea make_sea(const Scene& scene, double seconds) {
  const auto& from = scene.waves;
  Sea sea;
  if (from.count == 0 || from.amplitude <= 0.0) return sea;

  std::mt19937 random(static_cast<std::mt19937::result_type>(from.seed) * 2654435761U + 17U);
  const glm::dvec3 main_origin = any_direction(random);
  const double radius = scene.planet.radius;
  const double longest = from.length / radius;
  const double longest_speed = from.speed / radius;
  double squares = 0.0;
  double amplitude_sum = 0.0;
  double slope_sum = 0.0;
  for (int i = 0; i < from.count; ++i) {
    const double rank = from.count > 1 ? static_cast<double>(i) / (from.count - 1) : 0.0;
    const double length = longest * std::pow(0.2, rank) * (i == 0 ? 1.0 : 0.85 + 0.3 * uniform(random));
    const glm::dvec3 own = any_direction(random);
    glm::dvec3 origin = main_origin * (1.0 - from.spread) + own * from.spread;
    origin = glm::length(origin) > 1e-3 ? glm::normalize(origin) : own;
    const double start = turn * uniform(random);
    const double wavenumber = turn / length;
    const double speed = longest_speed * std::sqrt(length / longest);
    f64::Wave wave;
    wave.origin = origin;
    wave.amplitude = length / longest;
    wave.wavenumber = wavenumber;
    // Crests run away from the origin: the phase falls with time.
    wave.phase = std::remainder(start - std::fmod(wavenumber * speed * seconds, turn), turn);
    wave.pinch = 0.0;
    sea.waves.push_back(wave);
    squares += std::pow(length / longest, 2);
  }

  const double scale = from.amplitude / radius / std::sqrt(squares);
  for (f64::Wave& wave : sea.waves) {
    wave.amplitude *= scale;
    amplitude_sum += wave.amplitude;
    slope_sum += wave.amplitude * wave.wavenumber;
  }
  sea.steepness = std::min(from.steepness, most_pinch / std::max(slope_sum, 1e-12));
  sea.held = sea.steepness < from.steepness;
  sea.highest = amplitude_sum;
  for (f64::Wave& wave : sea.waves) wave.pinch = sea.steepness * wave.amplitude;
  return sea;
}

double whole_wave_depth(const Scene& scene, const Sea& sea) {
  return std::max(4.0 * scene.waves.amplitude / scene.planet.radius, 1.125 * sea.highest) + 1e-6;
}

}  // namespace terrella
