#include "reference/ground.hpp"

#include <algorithm>
#include <cmath>

#include "planet/terrain.hpp"
#include "reference/first_hit.hpp"

namespace terrella::reference {
namespace {

// The steepest slope of simplex noise, the fastest that it changes and the largest value, in cells
// (tests/laws/bounds_test.cpp measures them).
constexpr double noise_slope = 6.5, noise_curvature = 48.0, noise_range = 1.02;

// Finer layers (cells per radian) doubles and integers of 32 bits place no more.
constexpr double finest = 1e8;

// The most of a layer.
double layer_range(const f64::Terrain& terrain) { return terrain.ridged ? 1.0 : 0.5 + 0.5 * noise_range; }

// The least.
double least_of_layer(const f64::Terrain& terrain) {
  return terrain.ridged ? 1.0 - noise_range : 0.5 - 0.5 * noise_range;
}

// The most of a layer within a distance (cells) of a place with the given noise.
double most_of_layer(const f64::Noise& noise, double distance, const f64::Terrain& terrain) {
  const double slope = glm::length(noise.gradient) + 0.5 * noise_curvature * distance;
  const double rise = std::min(noise_slope, slope) * distance;
  const double most = terrain.ridged ? std::max(std::abs(noise.value) - rise, 0.0) : noise.value + rise;
  return std::min(f64::layer_value(most, terrain.ridged, terrain.sharpness), layer_range(terrain));
}

// As much as the craters of one size rise above the ground: where the rims of all eight cells around a place meet, and
// per distance; both in cells. Depth is at most 0.4 of a radius of at most 0.28; the rim is 0.22 depths high, no slope
// is above 2.25 depths a radius (tests/laws/bounds_test.cpp).
constexpr double bowls = 8.0 * 0.4 * 0.28, rims = 0.22 * bowls, rim_slope = 8.0 * 0.4 * 2.25;

// The sum of layers (0..1) at which the ground has a height; above 1: never.
double sum_for_height(double value, const f64::Terrain& terrain) {
  if (terrain.height <= 0.0) return 2.0;
  if (terrain.power == 0.0) return value > terrain.height ? 2.0 : 0.0;
  return value > terrain.height ? 2.0 : std::pow(std::max(value / terrain.height, 0.0), 1.0 / terrain.power);
}

}  // namespace

Ground::Ground(const Scene& scene, double footprint)
    : terrain_(exact_terrain_of(scene)), footprint_(std::max(footprint, 0.25 / finest)) {
  total_ = 0.0;
  double amplitude = 1.0;
  for (int i = 0; i < terrain_.octaves; ++i, amplitude *= terrain_.persistence) total_ += amplitude;
  highest_ = 1.0 + (terrain_.octaves > 0 ? terrain_.height : 0.0);
  if (terrain_.ice.sine <= 1.0 && terrain_.ice.sea > 0.0)
    highest_ = std::max(highest_, 1.0 + terrain_.ice.sea + f64::ice_thickness);
  double crater_frequency = terrain_.craters.frequency;
  for (int i = 0; i < terrain_.craters.sizes; ++i, crater_frequency *= 1.41421356)
    cells_of_craters_ += terrain_.craters.depth / crater_frequency;
}

f64::Height Ground::height_at(const glm::dvec3& direction) const {
  return f64::terrain_height_at(direction, terrain_, footprint_);
}

double Ground::left_in(double value, double frequency) const {
  return glm::mix(f64::layer_mean(terrain_.ridged), value, f64::layer_weight(frequency, footprint_));
}

f64::Noise Ground::noise_at(const glm::dvec3& direction, double frequency, int layer) const {
  const glm::dvec3 place = direction * frequency + f64::layer_offset(layer, terrain_.seed);
  return f64::simplex_noise(glm::ivec3(0), place, f64::layer_seed(layer, terrain_.seed));
}

double Ground::most_dug_up(const glm::dvec3& direction, double chord) const {
  const f64::Craters& craters = terrain_.craters;
  const double most = rims * cells_of_craters_, rise = craters.depth * rim_slope * craters.sizes * chord;
  if (rise >= most) return most;
  double here = 0.0;
  glm::dvec3 slope(0.0);
  f64::add_craters(direction, craters, footprint_, here, slope);
  return std::min(most, here + rise);
}

bool Ground::reaches(const glm::dvec3& direction, double radius) const {
  if (highest_ < radius) return false;
  const bool layers_alone = terrain_.ice.sine > 1.0 && terrain_.octaves > 0 && terrain_.height > 0.0;
  if (!layers_alone) return radius_at(direction) >= radius;
  // Far from the surface the coarse layers tell on which side of it the radius lies.
  constexpr int told_apart = 5;
  const double wanted = sum_for_height(radius - 1.0, terrain_) * total_;
  const double dug = cells_of_craters_ * total_ / terrain_.height;
  double known = 0.0, unknown = total_, amplitude = 1.0, frequency = terrain_.frequency;
  for (int i = 0; i < std::min(terrain_.octaves, told_apart); ++i) {
    const double noise = noise_at(direction, frequency, i).value;
    known += amplitude * left_in(f64::layer_value(noise, terrain_.ridged, terrain_.sharpness), frequency);
    unknown -= amplitude;
    if (known + unknown * layer_range(terrain_) + rims * dug < wanted) return false;
    if (known + unknown * least_of_layer(terrain_) - bowls * dug > wanted) return true;
    amplitude *= terrain_.persistence;
    frequency *= terrain_.lacunarity;
    if (frequency > finest) break;
  }
  return radius_at(direction) >= radius;
}

bool Ground::stays_below(const glm::dvec3& direction, double chord, double radius) const {
  if (highest_ < radius) return true;
  const bool ice =
      terrain_.ice.sine <= 1.0 && terrain_.ice.sea > 0.0 && std::abs(direction.z) + chord > terrain_.ice.sine - 0.08;
  if (ice && 1.0 + terrain_.ice.sea + f64::ice_thickness >= radius) return false;
  // No ground lies lower than the unit sphere, and a flat one lies at one height.
  if (radius <= 1.0) return false;
  if (terrain_.octaves == 0 || terrain_.height <= 0.0) return true;
  if (terrain_.power == 0.0) return highest_ < radius;
  const double dug_up = most_dug_up(direction, chord) / std::max(terrain_.height, 1e-12);
  const double allowed = (sum_for_height(radius - 1.0, terrain_) - dug_up) * total_;
  const double range = layer_range(terrain_);
  double known = 0.0, unknown = total_, amplitude = 1.0, frequency = terrain_.frequency;
  for (int i = 0; i < terrain_.octaves; ++i) {
    if (known + unknown * range < allowed) return true;
    // Noise that may take any value within the distance is not worth asking for: nor are all finer layers.
    if (frequency * chord > 0.4 || frequency > finest) return false;
    known +=
        amplitude * left_in(most_of_layer(noise_at(direction, frequency, i), frequency * chord, terrain_), frequency);
    unknown -= amplitude;
    amplitude *= terrain_.persistence;
    frequency *= terrain_.lacunarity;
  }
  return known < allowed;
}

std::optional<double> Ground::hit(const Ray& ray, double before, const Resolution& resolution) const {
  const std::optional<Span> shell = within_sphere(ray, highest_ * (1.0 + 1e-12));
  if (!shell) return std::nullopt;
  // The unit sphere lies under all ground.
  const std::optional<Span> core = within_sphere(ray, 1.0);
  const double end = core && core->to > 0.0 ? std::max(core->from, 0.0) : shell->to;
  const Span span = {std::max(shell->from, 0.0), std::min({end, shell->to, before})};
  const std::optional<double> found = first_hit(*this, ray, span, resolution);
  if (found || !core || core->from > before || core->from < 0.0) return found;
  return core->from;
}

}  // namespace terrella::reference
