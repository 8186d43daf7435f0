#include "planet/short_waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace terrella {
namespace {

// In lengths of a wave: from further away pictures of usual size don't show it.
constexpr double farthest_seen = 200.0;

}  // namespace

f64::ShortWave seen_from(const f64::Wave& wave, const glm::dvec3& anchor, const f64::Frame& axes, double felt_depth) {
  const double cosine = glm::dot(wave.origin, anchor), sine = glm::length(glm::cross(wave.origin, anchor));
  const glm::dvec3 outward = (cosine * anchor - wave.origin) / sine;
  const double phase = wave.phase + wave.wavenumber * std::atan2(sine, cosine);
  return {{glm::dot(outward, axes.east), glm::dot(outward, axes.north)},
          wave.wavenumber,
          std::remainder(phase, 2.0 * std::numbers::pi),
          wave.amplitude,
          wave.pinch,
          cosine / sine,
          f64::gained_phase(wave.wavenumber * felt_depth)};
}

NearWaves near_waves(const Sea& sea, const glm::dvec3& eye, double felt_depth) {
  NearWaves near;
  near.anchor = glm::normalize(eye);
  near.axes = f64::frame_at(near.anchor);
  if (sea.short_waves.empty()) return near;
  const glm::dvec3 size = glm::abs(near.anchor);
  const double most = std::max({size.x, size.y, size.z});
  const double reach = farthest_seen * 2.0 * std::numbers::pi / sea.short_waves.front().wavenumber;
  for (int axis = 0; axis < 3; ++axis) {
    // Where parts_of_regions begin, and as much further as that may change on the way.
    if (size[axis] / most < 0.95 - 2.0 * reach) continue;
    const int region = region_around(axis, near.anchor);
    auto& waves = near.waves.at(static_cast<std::size_t>(axis));
    for (const RegionalWave& wave : sea.short_waves)
      waves.push_back(seen_from(in_region(wave, region), near.anchor, near.axes, felt_depth));
  }
  return near;
}

f64::WaveSum waves_over(const Sea& sea, const NearWaves& near, const f64::Shore& shore) {
  const glm::dvec3 parts = f64::parts_of_regions(near.anchor);
  // The water of a still place that lies as far to one side as it is moved to the other.
  f64::WaveSum sum = f64::no_waves();
  for (int step = 0; step < 5; ++step) {
    const glm::dvec2 still = -sum.shift;
    const glm::dvec3 place = glm::normalize(near.anchor + still.x * near.axes.east + still.y * near.axes.north);
    sum = f64::no_waves();
    for (const f64::Wave& wave : sea.waves) f64::add_wave(sum, place, near.axes, wave, 1.0);
    for (int axis = 0; axis < 3; ++axis) {
      for (const f64::ShortWave& wave : near.waves.at(static_cast<std::size_t>(axis)))
        f64::add_short_wave(sum, f64::ashore(f64::course_of(wave, still), wave, shore), wave, parts[axis]);
    }
  }
  return sum;
}

}  // namespace terrella
