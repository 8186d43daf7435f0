#include "reference/ground.hpp"

#include <algorithm>
#include <cmath>

#include "planet/height_bounds.hpp"
#include "planet/noise_bounds.hpp"
#include "planet/terrain.hpp"
#include "reference/first_hit.hpp"
#include "reference/ground_on_ray.hpp"
#include "reference/ice_bounds.hpp"

namespace terrella::reference {
namespace {

// From here on layers (cells per radian) fade: doubles and integers of 32 bits place twice as fine ones no more.
constexpr double finest = 1e8;

Range range_of_layers(bool ridged) {
  if (ridged) return {1.0 - noise_range, 1.0};
  return {0.5 - 0.5 * noise_range, 0.5 + 0.5 * noise_range};
}

// A sum of layers of which some are known and the amplitudes of all others together.
struct PartialSum {
  Range known;
  double amplitude, unknown;

  // first: amplitude of the first layer; total: of all; hidden: of those that stay at their mean.
  PartialSum(double first, double total, double hidden, double mean)
      : known{hidden * mean, hidden * mean}, amplitude(first), unknown(total - hidden) {}

  void add(const Range& layer, double persistence) {
    known = {known.least + amplitude * layer.least, known.most + amplitude * layer.most};
    unknown -= amplitude;
    amplitude *= persistence;
  }

  // Over total; layers: any of those unknown.
  [[nodiscard]] Range mean(const Range& layers, double total) const {
    return {(known.least + unknown * layers.least) / total, (known.most + unknown * layers.most) / total};
  }
};

double cube(double x) { return x * x * x; }

// As much as the craters of one size rise and dig, in cells, where those of all eight cells around a place meet: each
// is at most 0.4 of a radius of at most 0.28 deep, its rim 0.22 depths high (tests/laws/bounds_test.cpp).
constexpr double bowls = 8.0 * 0.4 * 0.28, rims = 0.22 * bowls;

}  // namespace

Ground::Ground(const Scene& scene, double footprint)
    : terrain_(exact_terrain_of(scene)), map_(scene.terrain.map.map), footprint_(std::max(footprint, 0.25 / finest)) {
  sum_layers();
  const bool has_map = map_ != nullptr;
  if (has_map) beyond_map_ = f64::first_layer_beyond(map_->texel(), terrain_);
  highest_ = 1.0 + (terrain_.octaves > 0 || has_map ? terrain_.height : 0.0);
  if (terrain_.ice.sine <= 1.0 && terrain_.ice.sea > 0.0)
    highest_ = std::max(highest_, 1.0 + terrain_.ice.sea + terrain_.ice.thickness);
  double frequency = terrain_.craters.frequency;
  for (; shown_sizes_ < terrain_.craters.sizes && f64::crater_weight(frequency, footprint_) > 0.0; ++shown_sizes_) {
    crater_cells_ += terrain_.craters.depth / frequency;
    frequency *= f64::crater_step;
  }
}

void Ground::sum_layers() {
  const bool has_ranges = terrain_.ranges.part > 0.0 && !map_;
  double amplitude = 1.0, frequency = terrain_.frequency;
  for (int i = 0; i < terrain_.octaves; ++i) {
    const bool is_ridge = has_ranges && i >= terrain_.ranges.first;
    if (is_ridge && total_ridges_ == 0.0) first_ridges_ = amplitude;
    const bool is_shown = f64::layer_weight(frequency, footprint_) > 0.0;
    if (is_shown) ++shown_layers_;
    total_ += amplitude;
    total_ridges_ += is_ridge ? amplitude : 0.0;
    hidden_ += is_shown ? 0.0 : amplitude;
    hidden_ridges_ += is_ridge && !is_shown ? amplitude : 0.0;
    amplitude *= terrain_.persistence;
    frequency *= terrain_.lacunarity;
  }
  if (total_ridges_ <= f64::faintest_ridges) total_ridges_ = 0.0;
}

f64::Height Ground::height_at(const glm::dvec3& direction) const {
  return f64::terrain_height_at(direction, terrain_, footprint_);
}

double Ground::left_in(double value, double frequency, bool ridged) const {
  return glm::mix(f64::layer_mean(ridged), value, f64::layer_weight(frequency, footprint_));
}

Range Ground::noise_over(const Directions& directions, double frequency, int octave, NoiseMemory& memory) const {
  if (!memory.tells_of(directions, octave, frequency))
    memory.keep(octave, {directions.middle, f64::height_noise(directions.middle, terrain_, octave, frequency)});
  return reference::noise_over(directions, memory.of(octave), frequency);
}

Range Ground::layer_of(const Range& noise, double frequency, bool ridged) const {
  const auto value = [&](double n) { return f64::layer_value(n, ridged, terrain_.sharpness); };
  Range layer = {value(noise.least), value(noise.most)};
  if (ridged) {
    // From the middle of the range, as far as it goes to each side.
    const double middle = std::abs(0.5 * (noise.least + noise.most)), rise = 0.5 * (noise.most - noise.least);
    layer = {value(middle + rise), value(std::max(middle - rise, 0.0))};
  }
  const Range whole = range_of_layers(ridged);
  return {left_in(std::max(layer.least, whole.least), frequency, ridged),
          left_in(std::min(layer.most, whole.most), frequency, ridged)};
}

Range Ground::craters_around(const glm::dvec3& direction, double chord, double frequency, int size) const {
  const double reach = frequency * chord;
  const glm::dvec3 corner = direction * frequency - 0.5;
  const glm::ivec3 first(glm::floor(corner - reach)), last = glm::ivec3(glm::floor(corner + reach)) + 1;
  const unsigned seed = f64::crater_seed(size, terrain_.craters.seed);
  Range dug = {0.0, 0.0};
  glm::ivec3 cell;
  for (cell.z = first.z; cell.z <= last.z; ++cell.z) {
    for (cell.y = first.y; cell.y <= last.y; ++cell.y) {
      for (cell.x = first.x; cell.x <= last.x; ++cell.x) {
        const f64::Crater crater = f64::crater_of(cell, frequency, seed);
        if (crater.depth <= 0.0) continue;
        const double away = glm::distance(direction, crater.centre) * frequency;
        const double from = std::max(away - reach, 0.0) / crater.radius, to = (away + reach) / crater.radius;
        // It rises from the middle to the rim, and falls from there on.
        const double near = f64::crater_shape(from).height, far = f64::crater_shape(to).height;
        dug.least += crater.depth * std::min(near, far);
        dug.most += crater.depth * (from < 1.0 && to > 1.0 ? f64::crater_shape(1.0).height : std::max(near, far));
      }
    }
  }
  const double scale = terrain_.craters.depth * f64::crater_weight(frequency, footprint_) / frequency;
  return {scale * dug.least, scale * dug.most};
}

Range Ground::heights_of(const Range& means) const {
  const auto height = [&](double mean) {
    return f64::height_power(mean, (1.0 - terrain_.ranges.part) * terrain_.height, terrain_.power);
  };
  return {height(means.least), height(means.most)};
}

Range Ground::map_around(const glm::dvec3& direction, double chord) const {
  if (!map_) return {0.0, 0.0};
  const double height = f64::map_height_at(terrain_.map, direction, footprint_).value;
  const double change = map_->steepest() * 2.0 * std::asin(std::min(0.5 * chord, 1.0));
  return {std::max(height - change, double{map_->lowest()}), std::min(height + change, double{map_->highest()})};
}

Range Ground::heights_on(const Range& map, const Range& added) const {
  const auto height = [&](double part, double rise_at, double more) {
    return terrain_.height * std::clamp(part + f64::mapped_rise(rise_at, terrain_.power) * more, 0.0, 1.0);
  };
  return {height(map.least, added.least < 0.0 ? map.most : map.least, added.least),
          height(map.most, added.most < 0.0 ? map.least : map.most, added.most)};
}

Range Ground::ranges_over(const Range& means, const Range& ridges) const {
  const auto height = [&](double mean, double ridge) {
    return terrain_.ranges.part * terrain_.height * f64::range_cover(mean, terrain_.ranges.low) *
           cube(std::max(ridge, 0.0));
  };
  return {height(means.least, ridges.least), height(means.most, ridges.most)};
}

Range Ground::ice_over(const glm::dvec3& direction, double chord, const Range& told_from) const {
  const f64::Ice& ice = terrain_.ice;
  if (!may_freeze(ice, direction, chord)) return {0.0, 0.0};
  // What lies higher than all ice is told from it without a look at its floes.
  const double highest = ice.sea + ice.thickness;
  if (told_from.least > highest) return {0.0, highest};
  const Range around = ice_around(ice, direction, chord, footprint_);
  // Of the place that is furthest from the pole.
  const bool all_near = f64::ice_near({0.0, 0.0, std::max(std::abs(direction.z) - chord, 0.0)}, ice);
  return {all_near ? std::max(around.least, 0.0) : 0.0, std::max(around.most, 0.0)};
}

Range Ground::heights_over(const Directions& directions, const Range& told_from) const {
  NoiseMemory memory = no_memory();
  return heights_over(directions, told_from, memory);
}

Range Ground::heights_over(const Directions& directions, const Range& told_from, NoiseMemory& memory) const {
  const glm::dvec3& direction = directions.middle;
  const double chord = directions.chord;
  const Range ice = ice_over(direction, chord, told_from);
  const bool has_map = map_ != nullptr;
  if ((terrain_.octaves == 0 && !has_map) || terrain_.height <= 0.0) return ice;
  const Range map = map_around(direction, chord);
  if (terrain_.power == 0.0 && total_ridges_ == 0.0 && !has_map) return heights_of({0.0, 0.0}).under(ice);
  const f64::Craters& craters = terrain_.craters;
  const double mean_layer = f64::layer_mean(terrain_.ridged);
  PartialSum layers(1.0, total_, hidden_, mean_layer);
  PartialSum ridges(first_ridges_, total_ridges_, hidden_ridges_, f64::layer_mean(true));
  Range dug = {0.0, 0.0};
  double undug = crater_cells_, frequency = terrain_.frequency, crater_frequency = craters.frequency;
  const auto heights = [&] {
    const Range mean =
        terrain_.octaves > 0 ? layers.mean(range_of_layers(terrain_.ridged), total_) : Range{mean_layer, mean_layer};
    const Range dug_means = {mean.least + (dug.least - bowls * undug) / terrain_.height,
                             mean.most + (dug.most + rims * undug) / terrain_.height};
    if (has_map) return heights_on(map, {dug_means.least - mean_layer, dug_means.most - mean_layer}).under(ice);
    const Range smooth = heights_of(dug_means);
    if (total_ridges_ <= 0.0) return smooth.under(ice);
    const Range of_ranges = ranges_over(dug_means, ridges.mean(range_of_layers(true), total_ridges_));
    return Range{smooth.least + of_ranges.least, smooth.most + of_ranges.most}.under(ice);
  };
  for (int i = 0;; ++i) {
    // What may take any value within the distance is not worth asking for: nor is all that is finer.
    const bool is_of_map = i < beyond_map_;
    const bool layer_tells = i < shown_layers_ && (is_of_map || frequency * chord < 0.4);
    const bool craters_tell = i < shown_sizes_ && craters.depth > 0.0 && crater_frequency * chord < 0.4;
    if (!(layer_tells || craters_tell)) return heights();
    // Heights take longer than layers that need not be computed.
    const bool costs = craters_tell || !(is_of_map || memory.tells_of(directions, i, frequency));
    if (costs) {
      if (const Range known = heights(); known.lies_apart_from(told_from)) return known;
    }
    if (is_of_map) {
      layers.add({mean_layer, mean_layer}, terrain_.persistence);
      frequency *= terrain_.lacunarity;
    } else if (layer_tells) {
      const Range noise = noise_over(directions, frequency, i, memory);
      layers.add(layer_of(noise, frequency, terrain_.ridged), terrain_.persistence);
      if (total_ridges_ > 0.0 && i >= terrain_.ranges.first) {
        ridges.add(layer_of(noise, frequency, true), terrain_.persistence);
      }
      frequency *= terrain_.lacunarity;
    }
    if (craters_tell) {
      const Range size = craters_around(direction, chord, crater_frequency, i);
      dug = {dug.least + size.least, dug.most + size.most};
      undug -= craters.depth / crater_frequency;
      crater_frequency *= f64::crater_step;
    }
  }
}

bool Ground::reaches(const glm::dvec3& direction, double radius) const {
  const double height = radius - 1.0;
  if (highest_ < radius) return false;
  const Range range = heights_over({direction, 0.0}, {height, height});
  return range.lies_apart_from(height) ? range.least > height : radius_at(direction) >= radius;
}

bool Ground::stays_below(const Directions& directions, double radius, NoiseMemory& memory) const {
  const double height = radius - 1.0;
  // No ground lies lower than the unit sphere.
  if (highest_ < radius || height <= 0.0) return highest_ < radius;
  return heights_over(directions, {height, height}, memory).most < height;
}

std::optional<double> Ground::hit(const Ray& ray, double before, const Resolution& resolution) const {
  const std::optional<Span> shell = within_sphere(ray, highest_ * (1.0 + 1e-12));
  if (!shell) return std::nullopt;
  // The unit sphere lies under all ground.
  const std::optional<Span> core = within_sphere(ray, 1.0);
  const double end = core && core->to > 0.0 ? std::max(core->from, 0.0) : shell->to;
  const Span span = {std::max(shell->from, 0.0), std::min({end, shell->to, before})};
  const std::optional<double> found = first_hit(GroundOnRay(*this), ray, span, resolution);
  if (found || !core || core->from > before || core->from < 0.0) return found;
  return core->from;
}

}  // namespace terrella::reference
