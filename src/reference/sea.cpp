#include "reference/sea.hpp"

#include <cmath>
#include <limits>

#include "planet/needs.hpp"
#include "planet/shores.hpp"
#include "planet/short_waves.hpp"
#include "planet/spheres.hpp"
#include "planet/terrain.hpp"
#include "reference/first_hit.hpp"

namespace terrella::reference {
namespace {

// Of a slope or a stretch, in wavenumbers of its wave: one that fades around its origin changes by half as much again.
constexpr double fastest_change = 1.5;

// At most as much does water move aside, more or less than its neighbour, per distance between their still places.
double widest_stretch(const f64::WaveSum& sum) {
  return glm::length(glm::dvec4(sum.stretch_ee, sum.stretch_en, sum.stretch_ne, sum.stretch_nn));
}

// Of a wave seen from a place, there.
f64::Course course_over(const f64::ShortWave& seen, const f64::Shore& shore) {
  return f64::ashore(f64::course_of(seen, {0.0, 0.0}), seen, shore);
}

}  // namespace

Sea::Sea(const Scene& scene, double seconds, const Ground* ground)
    : sea_(make_sea(scene, seconds)),
      radius_(water_radius(scene)),
      whole_depth_(whole_wave_depth(sea_)),
      over_nodes_(has_nodes(ground_technique(scene))),
      shore_(shore_of(scene, sea_)),
      foam_layer_(foam_layer(scene, sea_)),
      terrain_(exact_terrain_of(scene)),
      ground_(ground) {
  if (ground != nullptr && !sea_.short_waves.empty()) felt_ground_.emplace(scene, longest_wave(sea_) / 16.0);
  const auto bend = [](const auto& wave) {
    return fastest_change * wave.amplitude * wave.wavenumber * wave.wavenumber;
  };
  for (const f64::Wave& wave : sea_.waves) {
    most_shift_ += wave.pinch;
    most_curvature_ += bend(wave);
  }
  for (int region = 0; region < regions; ++region) {
    for (const RegionalWave& wave : sea_.short_waves)
      short_waves_.at(static_cast<std::size_t>(region)).push_back(in_region(wave, region));
  }
  Together shifts, bends;
  for (const RegionalWave& wave : sea_.short_waves) {
    shifts.add(wave.pinch);
    bends.add(bend(wave));
  }
  most_shift_ += shifts.most();
  most_curvature_ += bends.most();
  most_squeeze_ = sea_.steepness * most_curvature_;
}

template <class Function>
void Sea::each_wave(const glm::dvec3& direction, double distance, const Function& function) const {
  for (const f64::Wave& wave : sea_.waves) function(wave, 1.0, 1.0);
  if (sea_.short_waves.empty()) return;
  // No part of a region changes faster.
  constexpr double steepest = 50.0;
  const glm::dvec3 parts = f64::parts_of_regions(direction);
  for (int axis = 0; axis < 3; ++axis) {
    const double most = std::min(1.0, parts[axis] + steepest * distance);
    // Regions begin where a direction's size along their axis is nearly its greatest.
    const double size = std::abs(direction[axis]) + 2.0 * distance;
    if (parts[axis] <= 0.0 &&
        size < 0.95 * std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)}))
      continue;
    const auto region = static_cast<std::size_t>(region_around(axis, direction));
    for (const f64::Wave& wave : short_waves_.at(region)) function(wave, parts[axis], most);
  }
}

double Sea::depth_at(const glm::dvec3& direction) const {
  return ground_ != nullptr ? radius_ - ground_->radius_at(direction) : bottomless;
}

f64::Shore Sea::shore_at(const glm::dvec3& direction, const f64::Frame& frame) const {
  f64::Shore shore = shore_;
  const f64::Height ground = felt_ground_->height_at(direction);
  shore.depth = radius_ - 1.0 - ground.value;
  shore.rise = shore.per_slope * f64::along_axes(ground.gradient, frame);
  return shore;
}

void Sea::add_wave(f64::WaveSum& sum, const glm::dvec3& still, const f64::Frame& frame, const f64::Wave& wave,
                   double part, const f64::Shore* shore) const {
  if (shore == nullptr || !sea_.is_short(wave)) return f64::add_wave(sum, still, frame, wave, part);
  const f64::ShortWave seen = seen_from(wave, still, frame, shore->felt_depth);
  f64::add_short_wave(sum, course_over(seen, *shore), seen, part);
}

f64::WaveSum Sea::whole_sum(const glm::dvec3& still, const f64::Frame& frame, bool deep) const {
  f64::WaveSum sum = f64::no_waves();
  const bool feels = !deep && felt_ground_;
  const f64::Shore shore = feels ? shore_at(still, frame) : shore_;
  each_wave(still, 0.0, [&](const f64::Wave& wave, double part, double) {
    if (part > 0.0) add_wave(sum, still, frame, wave, part, feels ? &shore : nullptr);
  });
  return sum;
}

WaterAt Sea::from(const glm::dvec3& still, bool deep) const {
  WaterAt at;
  at.still = still;
  at.frame = f64::frame_at(still);
  at.depth = ground_ == nullptr ? bottomless : whole_depth_;
  glm::dvec3 gradient(0.0);
  if (!deep) {
    const f64::Height ground = ground_->height_at(still);
    at.depth = radius_ - 1.0 - ground.value;
    gradient = ground.gradient;
  }
  const f64::WaveSum whole = whole_sum(still, at.frame, deep);
  at.sum = over_nodes_ ? f64::held_ashore(whole, at.frame, at.depth, gradient, whole_depth_)
                       : f64::held_in_frame(whole, at.frame, at.depth, gradient, whole_depth_);
  at.place = still * radius_ + f64::wave_offset(still, at.frame, at.sum);
  return at;
}

WaterAt Sea::over(const glm::dvec3& direction) const {
  const bool deep = depths_around(direction, 1.01 * most_shift_).least >= shore_.felt_depth;
  WaterAt at = over(direction, deep);
  if (deep) at.depth = depth_at(at.still);  // otherwise it is known
  return at;
}

WaterAt Sea::over(const glm::dvec3& direction, bool deep, double beside) const {
  WaterAt at = from(direction, deep);
  // Newton's method over the sphere: how far the water lies aside of the direction, over how it moves with its still
  // place.
  constexpr int most_steps = 40;
  for (int i = 0; i < most_steps && has_waves(); ++i) {
    const glm::dvec3 aside = direction * glm::length(at.place) - at.place;
    const glm::dvec2 miss(glm::dot(aside, at.frame.east), glm::dot(aside, at.frame.north));
    const double missed = std::abs(miss.x) + std::abs(miss.y);
    const double gap = beside > 0.0 ? std::abs(glm::length(at.place) - beside) : 0.0;
    if (missed < std::max(1e-13, 0.02 * gap)) break;
    const double a = radius_ + at.sum.height + at.sum.stretch_ee, b = at.sum.stretch_en;
    const double c = at.sum.stretch_ne, d = radius_ + at.sum.height + at.sum.stretch_nn;
    // At a shore, where the ground holds waves back, the surface may fold; steps are held there.
    const double area = std::max(a * d - b * c, 0.05);
    glm::dvec2 move(glm::dvec2(d * miss.x - b * miss.y, a * miss.y - c * miss.x) / area);
    move *= std::min(1.0, (i < 8 ? 1.0 : 0.25) * most_shift_ / glm::length(move));
    at = from(glm::normalize(at.still + move.x * at.frame.east + move.y * at.frame.north), deep);
  }
  return at;
}

// The highest radius of deep water over all directions within chord of that of the given water, from how steep it is
// and how tightly it is squeezed there and how fast both may change.
double Sea::most_of_deep_water(const WaterAt& middle, double chord) const {
  const f64::WaveSum& sum = middle.sum;
  // The least by which water over a direction moves as its still place does.
  const double least = 0.98 * (1.0 - widest_stretch(sum));
  const double under_root = least * least - 2.0 * most_squeeze_ * chord;
  double away = chord + 2.0 * most_shift_;
  if (least > 0.0 && under_root > 0.0) away = std::min(away, 1.02 * 2.0 * chord / (least + std::sqrt(under_root)));
  const double slope = glm::length(sum.slope) + glm::length(sum.shift);
  return glm::length(middle.place) + 1.02 * slope * away + 0.5 * most_curvature_ * away * away;
}

Sea::Around Sea::whole_waves_around(const glm::dvec3& direction, double chord, double told_from,
                                    double least_depth) const {
  const f64::Frame frame = f64::frame_at(direction);
  const bool feels = least_depth < shore_.felt_depth && felt_ground_;
  const f64::Shore shore = feels ? shore_at(direction, frame) : shore_;
  // Nine in ten shores of a planet are less than twice as steep as most, and fine layers are not felt.
  const double steepest = std::max(3.0, 2.0 * glm::length(shore.rise));
  Range range = {-sea_.highest, sea_.highest};
  // From how far water may come to lie there. Waves that are short beside that may stand at any height; of the longer
  // ones slope and squeeze at the middle tell how they rise, and how far they move water: so a bound on the way gives a
  // smaller one.
  double away = chord + 1.01 * most_shift_;
  for (int round = 0; round < 3; ++round) {
    f64::WaveSum felt = f64::no_waves();
    double any_height = 0.0, any_shift = 0.0, curvature = 0.0, squeeze = 0.0;
    each_wave(direction, away, [&](const f64::Wave& wave, double part, double most) {
      const double shallowest = std::max(wave.wavenumber * least_depth, f64::shortest_depth);
      const double shorter = feels ? 1.0 + steepest * (f64::shortened(shallowest) - 1.0) : 1.0;
      const double wavenumber = shorter * wave.wavenumber;
      const bool is_short = wavenumber * away > 1.0;
      const double any = is_short ? most : most - part;
      any_height += any * wave.amplitude;
      any_shift += any * wave.pinch;
      if (is_short) return;
      add_wave(felt, direction, frame, wave, part, feels ? &shore : nullptr);
      curvature += fastest_change * most * wave.amplitude * wavenumber * wavenumber;
      squeeze += fastest_change * most * wave.pinch * wavenumber * wavenumber;
    });
    // Many short waves never meet (Sea::highest).
    any_height = std::min(any_height, sea_.highest);
    any_shift = std::min(any_shift, most_shift_);
    const double widest = widest_stretch(felt), shift = glm::length(felt.shift);
    double nearer = away;
    for (int i = 0; i < 4; ++i) {
      const double moved = shift + any_shift + widest * nearer + 0.5 * squeeze * nearer * nearer;
      nearer = std::min(nearer, chord + 1.01 * moved);
    }
    const double aside = nearer - chord;
    const double slope = 1.02 * (glm::length(felt.slope) + shift);
    const double rise = any_height + slope * nearer + 0.5 * curvature * nearer * nearer;
    range.least = std::max(range.least, felt.height - rise);
    range.most = std::min(range.most, felt.height + rise + aside * aside);
    const bool last = range.lies_apart_from(told_from) || nearer > 0.7 * away;
    away = nearer;
    if (last) break;
  }
  return {range, away, true};
}

f64::FoamLace Sea::lace_at(const glm::dvec3& still) const {
  if (ground_ == nullptr || foam_layer_ < 0) return {0.0, 0.0};
  const auto layer = [&](int i) {
    const double frequency = terrain_.frequency * std::pow(terrain_.lacunarity, i);
    return f64::height_noise(still, terrain_, i, frequency).value;
  };
  return {f64::lace_of(layer(foam_layer_), layer(foam_layer_ + 1), 1.0), 1.0};
}

double Sea::gathered_at(const glm::dvec3& still, double way, double refraction_index) const {
  if (!felt_ground_) return 1.0;
  const f64::Frame frame = f64::frame_at(still);
  const f64::Shore shore = shore_at(still, frame);
  f64::Lens lens = f64::no_lens();
  each_wave(still, 0.0, [&](const f64::Wave& wave, double part, double) {
    if (part <= 0.0 || !sea_.is_short(wave)) return;
    const f64::ShortWave seen = seen_from(wave, still, frame, shore.felt_depth);
    f64::add_lens(lens, course_over(seen, shore), seen, part);
  });
  return f64::gathered_light(lens, left_over(shore.depth), way, refraction_index);
}

double Sea::left_over(double depth) const {
  return over_nodes_ ? f64::left_ashore(depth, whole_depth_) : f64::left_by_ground(depth, whole_depth_);
}

Range Sea::depths_around(const glm::dvec3& direction, double distance) const {
  constexpr double no_ground = std::numeric_limits<double>::infinity();
  if (ground_ == nullptr) return {no_ground, no_ground};
  const double still = radius_ - 1.0;
  const Range ground = ground_->heights_over({direction, distance}, {still - shore_.felt_depth, still});
  return {still - ground.most, still - ground.least};
}

Sea::Around Sea::around(const glm::dvec3& direction, double chord, double told_from) const {
  const Range depths = depths_around(direction, chord + 1.01 * most_shift_);
  Around around = whole_waves_around(direction, chord, told_from, depths.least);
  // The ground holds crests and troughs back, no further than to the still water.
  const Range left = {left_over(depths.least), left_over(depths.most)};
  const Range whole = around.heights;
  around.heights.least = whole.least * (whole.least < 0.0 ? left.most : left.least);
  around.heights.most = whole.most * (whole.most > 0.0 ? left.most : left.least);
  around.deep = depths.least >= shore_.felt_depth;
  return around;
}

bool Sea::reaches(const glm::dvec3& direction, double radius) const {
  const double height = radius - radius_;
  if (sea_.highest < std::abs(height)) return height <= 0.0;
  const Around water = around(direction, 0.0, height);
  if (water.heights.lies_apart_from(height)) return water.heights.least > height;
  return glm::length(over(direction, water.deep, radius).place) >= radius;
}

bool Sea::stays_below(const Directions& directions, double radius) const {
  const double height = radius - radius_;
  if (sea_.highest < height) return true;
  if (!has_waves()) return height > 0.0;
  const Around water = around(directions.middle, directions.chord, height);
  if (water.heights.most < height) return true;
  return water.deep && most_of_deep_water(over(directions.middle, true), directions.chord) < radius;
}

bool Sea::stays_above(const Directions& directions, double radius) const {
  const double height = radius - radius_;
  if (height < -sea_.highest) return true;
  if (!has_waves()) return height < 0.0;
  return around(directions.middle, directions.chord, height).heights.least > height;
}

std::optional<double> Sea::hit_from_below(const Ray& ray, double before, const Resolution& resolution) const {
  const std::optional<Span> shell = within_sphere(ray, radius_ + sea_.highest);
  if (!shell || shell->to <= 0.0) return std::nullopt;
  const double end = std::min(shell->to, before);
  if (!has_waves()) return end == shell->to ? std::optional(end) : std::nullopt;
  return first_hit<Side::below>(*this, ray, {0.0, end}, resolution);
}

std::optional<double> Sea::hit(const Ray& ray, double before, const Resolution& resolution) const {
  const std::optional<Span> still = within_sphere(ray, radius_);
  if (!has_waves()) {
    const bool seen = still && still->from > 0.0 && still->from < before;
    return seen ? std::optional(still->from) : std::nullopt;
  }
  const std::optional<Span> shell = within_sphere(ray, radius_ + sea_.highest);
  if (!shell || shell->to <= 0.0) return std::nullopt;
  const std::optional<Span> core = within_sphere(ray, radius_ - sea_.highest);
  const double end = core && core->from > 0.0 ? core->from : shell->to;
  return first_hit(*this, ray, {std::max(shell->from, 0.0), std::min(end, before)}, resolution);
}

}  // namespace terrella::reference
