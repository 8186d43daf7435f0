#include "reference/ice_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "reference/noise_over.hpp"

namespace terrella::reference {
namespace {

// A strewn point of lib/ice.glsl, whose floe is the cell of places that it is nearest to.
struct Point {
  double away;  // from the middle, cells
  double dice;
};

// The points that floe_at finds from any place within a reach of the middle. It looks in the 27 cells around a place,
// and misses points further away: which they are changes where a place crosses into another cell.
class Strewn {
 public:
  // middle, reach: cells; reach: below 0.5, so that the eight cells in the midst are looked in from everywhere.
  Strewn(const glm::dvec3& middle, double reach, unsigned seed) : reach_(reach) {
    const glm::ivec3 from(glm::floor(middle - reach)), to(glm::floor(middle + reach));
    glm::ivec3 cell;
    for (cell.z = from.z - 1; cell.z <= to.z + 1; ++cell.z) {
      for (cell.y = from.y - 1; cell.y <= to.y + 1; ++cell.y) {
        for (cell.x = from.x - 1; cell.x <= to.x + 1; ++cell.x) {
          const unsigned hash = f64::hash_cell(cell, seed);
          const double away = glm::distance(middle, glm::dvec3(cell) + f64::hash_parts(hash) / 1023.0);
          points_[count_++] = {away, static_cast<double>((hash >> 5) & 1023U) / 1023.0};
          nearest_.add(away);
          if (glm::all(glm::greaterThanEqual(cell, to - 1)) && glm::all(glm::lessThanEqual(cell, from + 1)))
            nearest_of_all_.add(away);
        }
      }
    }
  }

  // Floe::from_rim. Each of two distances changes by at most the reach; one place's nearest point is another's only if
  // no other point comes nearer on the way, and only if that is looked in the cell where it lies.
  [[nodiscard]] Range from_rim() const {
    return {std::max(0.5 * (nearest_.second - nearest_of_all_.first) - reach_, 0.0),
            0.5 * (nearest_of_all_.second - nearest_.first) + reach_};
  }

  // Whether any floe there may have such dice.
  template <class Test>
  [[nodiscard]] bool any(const Test& test) const {
    return std::any_of(points_.begin(), points_.begin() + count_, [&](const Point& point) {
      return point.away - reach_ <= nearest_of_all_.first + reach_ && test(point.dice);
    });
  }

 private:
  struct Two {
    double first = 4.0, second = 4.0;  // as in floe_at

    void add(double away) {
      second = std::min(second, std::max(first, away));
      first = std::min(first, away);
    }
  };

  double reach_;
  std::array<Point, 64> points_;
  int count_ = 0;
  Two nearest_, nearest_of_all_;  // of all points, of those found from everywhere
};

// Of the distance from a floe's rim, rad, negative where the floe is missing (floes in ice_cover).
Range floes_around(const f64::Ice& ice, const glm::dvec3& direction, double chord, const Range& within) {
  const auto least_dice_of_missing = [](double w) { return 0.45 + 0.6 * glm::smoothstep(-0.03, 0.05, w); };
  const auto gap = [](double w) { return 0.006 * (1.0 - glm::smoothstep(0.0, 0.12, w)); };
  const Strewn strewn(f64::floe_frequency * direction, f64::floe_frequency * chord, ice.seed + 902U);
  const Range rim = strewn.from_rim();
  const bool may_lie = strewn.any([&](double dice) { return dice <= least_dice_of_missing(within.most); });
  const bool may_miss = strewn.any([&](double dice) { return dice > least_dice_of_missing(within.least); });
  const double least = may_miss ? -rim.most : rim.least, most = may_lie ? rim.most : -rim.least;
  return {least / f64::floe_frequency - gap(within.least), most / f64::floe_frequency - gap(within.most)};
}

// Of ice_cover.
Range cover_around(const f64::Ice& ice, const glm::dvec3& direction, double chord, double footprint) {
  constexpr double bays_frequency = 6.0;
  const f64::Noise noise = f64::simplex_noise(glm::ivec3(0), bays_frequency * direction, ice.seed + 901U);
  const Range bays = noise_over({direction, chord}, {direction, noise}, bays_frequency);
  const double polar = std::abs(direction.z) - ice.sine;
  const Range within = {polar - chord + 0.035 * bays.least, polar + chord + 0.035 * bays.most};
  const double shown = f64::layer_weight(f64::floe_frequency, footprint);
  const Range floes = floes_around(ice, direction, chord, within);
  return {std::min(within.least + 0.03, glm::mix(within.least, floes.least, shown)),
          std::min(within.most + 0.03, glm::mix(within.most, floes.most, shown))};
}

}  // namespace

Range ice_around(const f64::Ice& ice, const glm::dvec3& direction, double chord, double footprint) {
  Range cover = {-1.0, 1.0};
  if (f64::floe_frequency * chord < 0.5) cover = cover_around(ice, direction, chord, footprint);
  return {f64::ice_height(cover.least, ice), f64::ice_height(cover.most, ice)};
}

}  // namespace terrella::reference
