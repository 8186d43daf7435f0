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
          const double away = glm::distance(middle, f64::floe_point(cell, hash));
          points_[count_++] = {away, f64::floe_dice(hash)};
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
  const Strewn strewn(f64::floe_frequency * direction, f64::floe_frequency * chord, f64::floe_seed(ice));
  const Range rim = strewn.from_rim();
  const bool may_lie = strewn.any([&](double dice) { return dice <= f64::dice_of_missing(within.most); });
  const bool may_miss = strewn.any([&](double dice) { return dice > f64::dice_of_missing(within.least); });
  const double least = may_miss ? -rim.most : rim.least, most = may_lie ? rim.most : -rim.least;
  return {least / f64::floe_frequency - f64::floes_apart(within.least),
          most / f64::floe_frequency - f64::floes_apart(within.most)};
}

// Of ice_cover.
Range cover_around(const f64::Ice& ice, const glm::dvec3& direction, double chord, double footprint) {
  const Range bays = noise_over({direction, chord}, {direction, f64::bays_noise(direction, ice)}, f64::bays_frequency);
  const double polar = std::abs(direction.z);
  const Range within = {f64::within_edge(polar - chord, bays.least, ice),
                        f64::within_edge(polar + chord, bays.most, ice)};
  const Range floes = floes_around(ice, direction, chord, within);
  return {f64::seen_cover(within.least, floes.least, footprint), f64::seen_cover(within.most, floes.most, footprint)};
}

}  // namespace

Range ice_around(const f64::Ice& ice, const glm::dvec3& direction, double chord, double footprint) {
  Range cover = {-1.0, 1.0};
  if (f64::floe_frequency * chord < 0.5) cover = cover_around(ice, direction, chord, footprint);
  return {f64::ice_height(cover.least, ice), f64::ice_height(cover.most, ice)};
}

}  // namespace terrella::reference
