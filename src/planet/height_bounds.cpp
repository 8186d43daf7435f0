#include "planet/height_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "planet/noise_bounds.hpp"

namespace terrella {
namespace {

// How far the mean of layers, from the first on, may be from what samples say: by their slope, and by what was left
// out.
double change_of_layers(const f64::Terrain& terrain, int first, bool ridged, double footprint, double apart) {
  const double steepest = (ridged ? 1.2 : 0.5) * noise_slope;  // of layer_value, per cell
  double change = 0.0, amplitude = 1.0, total = 0.0, frequency = terrain.frequency;
  for (int i = 0; i < terrain.octaves; ++i, frequency *= terrain.lacunarity) {
    if (i < first) continue;
    const double left_out = 1.0 - f64::layer_weight(frequency, footprint);
    change += amplitude * std::min(noise_range, steepest * frequency * apart + 0.75 * left_out);
    total += amplitude;
    amplitude *= terrain.persistence;
  }
  return total > 0.0 ? change / total : 0.0;
}

// The same of craters, radii: as far as one rises or digs, its bowl as steep as the deepest (Crater in
// lib/craters.glsl).
double change_by_craters(const f64::Craters& craters, double footprint, double apart) {
  constexpr double deepest = 0.4 * 0.28, steepest = 1.6 * 0.4;
  constexpr double overlapping = 3.0;
  double change = 0.0, frequency = craters.frequency;
  for (int i = 0; i < craters.sizes; ++i, frequency *= f64::crater_step) {
    const double left_out = 1.0 - f64::crater_weight(frequency, footprint);
    change += overlapping * craters.depth / frequency *
              std::min(1.22 * deepest, steepest * frequency * apart + 1.22 * deepest * left_out);
  }
  return change;
}

// Where ranges stand, heights do not tell the layers: by the steepest that each part can be.
HeightRange change_with_ranges(const f64::Terrain& terrain, const HeightRange& computed, double footprint, double apart,
                               double of_layers) {
  constexpr double steepest_cover = 6.0, steepest_cube = 3.0;
  const double ridges = change_of_layers(terrain, terrain.ranges.first, true, footprint, apart);
  // A power below 1 is steepest at 0, and there nowhere above 1; with none the ground under the ranges is flat.
  const double smooth = terrain.power > 0.0 ? std::min(std::max(terrain.power, 1.0) * of_layers, 1.0) : 0.0;
  const double ranges = std::min(steepest_cover * of_layers + steepest_cube * ridges, 1.0);
  const double power_below_one =
      terrain.power > 0.0 && terrain.power < 1.0 ? std::pow(of_layers, terrain.power) : smooth;
  const double change =
      terrain.height * ((1.0 - terrain.ranges.part) * std::max(smooth, power_below_one) + terrain.ranges.part * ranges);
  return {std::max(computed.lowest - change, 0.0), std::min(computed.highest + change, terrain.height)};
}

// How far a map of heights may be from what samples say, as a part of the highest: by its slope, and by what they left
// out: a coarser level, whose texels are at most two footprints wide, tells of heights up to three texels away.
double change_of_map(const HeightMap& map, double footprint, double apart) {
  const double told_from = footprint > map.texel() ? 13.0 * footprint : 0.0;
  return std::min(map.steepest() * (apart + told_from), static_cast<double>(map.highest() - map.lowest()));
}

// By the steepest that a map and the layers finer than it can be, and what these add at most.
HeightRange change_on_map(const f64::Terrain& terrain, const HeightRange& computed, double footprint, double apart) {
  const HeightMap& map = *terrain.map.map;
  const int first = f64::first_layer_beyond(map.texel(), terrain), finer = terrain.octaves - first;
  double share = 0.0, change = 0.0;
  if (finer > 0) {
    share = std::pow(terrain.persistence, first) * f64::amplitude_sum(terrain.persistence, finer) /
            f64::amplitude_sum(terrain.persistence, terrain.octaves);
    change = share * change_of_layers(terrain, first, terrain.ridged, footprint, apart);
  }
  double most_added = 0.75 * share;
  if (terrain.craters.depth > 0.0) {
    change += change_by_craters(terrain.craters, footprint, apart) / terrain.height;
    most_added += change_by_craters(terrain.craters, 1.0, 1.0) / terrain.height;
  }
  const double bend = f64::mapped_rise_slope(0.0, terrain.power) * most_added;
  const double by = terrain.height * ((1.0 + bend) * change_of_map(map, footprint, apart) +
                                      f64::mapped_rise(1.0, terrain.power) * change);
  return {std::max(computed.lowest - by, 0.0), std::min(computed.highest + by, terrain.height)};
}

}  // namespace

bool may_freeze(const f64::Ice& ice, const glm::dvec3& direction, double distance) {
  constexpr double ragged = 0.08;  // as far as floes reach beyond their latitude (ice_near in lib/ice.glsl)
  return ice.sine <= 1.0 && ice.sea > 0.0 && std::abs(direction.z) + distance > ice.sine - ragged;
}

HeightRange heights_around(const f64::Terrain& terrain, const HeightRange& computed, double footprint, double apart,
                           bool may_freeze) {
  HeightRange range = computed;
  const bool is_flat = terrain.power == 0.0 && terrain.ranges.part == 0.0;
  if (terrain.map.map != nullptr) {
    if (terrain.height > 0.0) range = change_on_map(terrain, computed, footprint, apart);
  } else if (terrain.octaves > 0 && terrain.height > 0.0 && !is_flat) {
    // In the sum of layers, before the power that makes plains flat: there changes are the same at any height.
    double change = change_of_layers(terrain, 0, terrain.ridged, footprint, apart);
    if (terrain.craters.depth > 0.0) change += change_by_craters(terrain.craters, footprint, apart) / terrain.height;
    const auto changed = [&](double height, double by) {
      const double layers = std::pow(std::clamp(height / terrain.height, 0.0, 1.0), 1.0 / terrain.power);
      return f64::height_power(layers + by, terrain.height, terrain.power);
    };
    range = terrain.ranges.part > 0.0
                ? change_with_ranges(terrain, computed, footprint, apart, change)
                : HeightRange{changed(computed.lowest, -change), changed(computed.highest, change)};
  }
  // Ice lies over what is lower: its own thickness is all that it can change from place to place.
  if (may_freeze) range.highest = std::max({range.highest, computed.highest, terrain.ice.sea + terrain.ice.thickness});
  return range;
}

}  // namespace terrella
