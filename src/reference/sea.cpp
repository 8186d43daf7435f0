#include "reference/sea.hpp"

#include <cmath>

#include "planet/spheres.hpp"
#include "planet/terrain.hpp"
#include "reference/first_hit.hpp"

namespace terrella::reference {
namespace {

constexpr int water_calm = 2;  // place in the choice list of params.inc
constexpr double bottomless = 1.0;

}  // namespace

Sea::Sea(const Scene& scene, double seconds, const Ground* ground)
    : radius_(water_radius(scene)), whole_depth_(1.0), ground_(ground) {
  if (scene.water.model != water_calm) sea_ = make_sea(scene, seconds);
  whole_depth_ = whole_wave_depth(scene, sea_);
  for (const f64::Wave& wave : sea_.waves) most_shift_ += wave.pinch;
}

double Sea::depth_at(const glm::dvec3& direction) const {
  return ground_ != nullptr ? radius_ - ground_->radius_at(direction) : bottomless;
}

f64::WaveSum Sea::whole_sum(const glm::dvec3& still, const f64::Frame& frame) const {
  f64::WaveSum sum = f64::no_waves();
  for (const f64::Wave& wave : sea_.waves) f64::add_wave(sum, still, frame, wave, 1.0);
  return sum;
}

WaterAt Sea::from(const glm::dvec3& still) const {
  WaterAt at;
  at.still = still;
  at.frame = f64::frame_at(still);
  glm::dvec2 slope(0.0);
  at.depth = bottomless;
  if (ground_ != nullptr) {
    const f64::Height ground = ground_->height_at(still);
    at.depth = radius_ - 1.0 - ground.value;
    slope = {glm::dot(ground.gradient, at.frame.east), glm::dot(ground.gradient, at.frame.north)};
  }
  at.sum = f64::held_by_ground(whole_sum(still, at.frame), at.depth, slope, whole_depth_);
  at.place = still * radius_ + f64::wave_offset(still, at.frame, at.sum);
  return at;
}

WaterAt Sea::over(const glm::dvec3& direction) const {
  WaterAt at = from(direction);
  if (sea_.waves.empty()) return at;
  // Newton's method over the sphere: how far the water lies aside of the direction, over how it moves with its still
  // place.
  constexpr int most_steps = 12;
  for (int i = 0; i < most_steps; ++i) {
    const glm::dvec3 aside = direction * glm::length(at.place) - at.place;
    const glm::dvec2 miss(glm::dot(aside, at.frame.east), glm::dot(aside, at.frame.north));
    if (std::abs(miss.x) + std::abs(miss.y) < 1e-14) break;
    const double a = radius_ + at.sum.height + at.sum.stretch_ee, b = at.sum.stretch_en;
    const double c = at.sum.stretch_ne, d = radius_ + at.sum.height + at.sum.stretch_nn;
    const double area = std::max(a * d - b * c, 0.02);  // small steps where the surface is about to fold
    const glm::dvec2 move(glm::dvec2(d * miss.x - b * miss.y, a * miss.y - c * miss.x) / area);
    at = from(glm::normalize(at.still + move.x * at.frame.east + move.y * at.frame.north));
  }
  return at;
}

bool Sea::stays_below(const glm::dvec3& direction, double chord, double radius) const {
  if (radius_ + sea_.highest < radius) return true;
  if (sea_.waves.empty()) return radius_ < radius;
  // Water that may lie over the directions, from its middle on.
  const double around = chord + 1.01 * most_shift_;
  double rise = 0.0;
  // A wave's height has at most the slope of a sine; where it fades around its origin, a quarter more.
  for (const f64::Wave& wave : sea_.waves) rise += wave.amplitude * std::min(2.0, 1.25 * wave.wavenumber * around);
  const double height = whole_sum(direction, f64::frame_at(direction)).height + rise;
  if (height >= 0.0) return radius_ + height < radius;
  // A trough is held where the water is shallow.
  const bool deep = ground_ == nullptr || ground_->stays_below(direction, around, radius_ - whole_depth_);
  return radius_ + (deep ? height : 0.0) < radius;
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
