#include "planet/persistent_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "formulas/formulas.hpp"

namespace terrella {
namespace {

// With 2 cells at the rim are twice as long as in the middle, with the 4 of the paper four times.
constexpr int power = 2;

// It is made for an eye that is so much higher, reaches so much further than that sees, and serves one that is so much
// lower.
constexpr double spare_above = 1.3, spare_aside = 1.05, spare_below = 0.5;

// Even at sea, where no terrain rises, it is to be wider than a point.
constexpr double least_altitude = 1e-9;

double altitude_of(const glm::dvec3& eye) { return std::max(glm::length(eye) - 1.0, least_altitude); }

// Beyond a quarter turn the corners of the square fall short of its sides, by no more than this makes up for. The
// middle of the grid stays on its side of the planet's centre.
double offset_that_covers(double zs) { return zs >= 0.0 ? zs : std::max(std::numbers::sqrt2 * zs, -0.95); }

}  // namespace

PersistentGrid::PersistentGrid(const glm::dvec3& eye, double top) : eye_(eye), altitude_(altitude_of(eye)), top_(top) {
  CHECK(top >= 0.0, top);
  w_ = glm::normalize(eye);
  u_ = f64::perpendicular(w_);
  v_ = glm::cross(w_, u_);
  zs_ = offset_that_covers(1.0 / std::tan(spare_aside * f64::grid_offset(1.0, spare_above * altitude_, top).phi));
  reached_ =
      std::min(std::atan2(1.0, zs_), std::atan2(std::numbers::sqrt2, zs_));  // in the middle of sides; at corners
  served_ = 0.5 * (reached_ + farthest_seen(eye, top));
  measure_cells();
}

double PersistentGrid::farthest_seen(const glm::dvec3& eye, double top) const {
  return f64::hidden_angle(1.0, altitude_of(eye), top) + f64::angle_between(w_, glm::normalize(eye));
}

bool PersistentGrid::reaches(const glm::dvec3& eye, double top) const { return farthest_seen(eye, top) <= reached_; }

bool PersistentGrid::serves(const glm::dvec3& eye, double top) const {
  return altitude_of(eye) >= spare_below * altitude_ && farthest_seen(eye, top) <= served_;
}

double PersistentGrid::edge(int level) const { return std::ldexp(2.0 * stretch_, -level); }

glm::dvec3 PersistentGrid::direction_on(int, double x, double y) const {
  const glm::dvec3 d = f64::grid_direction(x, y, f64::grid_rise(x, y, power), zs_);
  // x and y of a face turn clockwise from outside, as v and u do.
  return d.x * v_ + (d.y * u_ + d.z * w_);
}

void PersistentGrid::measure_cells() {
  constexpr int samples = 32;
  constexpr double step = 1e-5, spare = 1.02;
  double side = 0.0, diagonal = 0.0;
  for (int j = 0; j <= samples; ++j) {
    for (int i = 0; i <= samples; ++i) {
      const double x = std::max(2.0 * i / samples - 1.0, step - 1.0), y = std::max(2.0 * j / samples - 1.0, step - 1.0);
      const glm::dvec3 here = direction_on(0, x, y), along_x = direction_on(0, x - step, y) - here,
                       along_y = direction_on(0, x, y - step) - here;
      side = std::max({side, glm::length(along_x), glm::length(along_y)});
      diagonal = std::max({diagonal, glm::length(along_x + along_y), glm::length(along_x - along_y)});
    }
  }
  stretch_ = spare * side / step;
  reach_ = spare * diagonal / side;
}

}  // namespace terrella
