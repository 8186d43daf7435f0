#include "planet/node_horizon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace terrella {
namespace {

constexpr double nowhere = -std::numeric_limits<double>::infinity();

// Grows with the azimuth as an angle does, from 0 to 4 in a full turn, and by 2 in half of one; nowhere faster than the
// angle in radians.
double azimuth_of(const glm::dvec2& v) {
  const double part = v.y / (std::abs(v.x) + std::abs(v.y));
  return v.x >= 0.0 ? (v.y >= 0.0 ? part : 4.0 + part) : 2.0 - part;
}

// Of the sight of an eye that stands upright on the sphere.
class Eye {
 public:
  explicit Eye(const glm::dvec3& place)
      : radius_(glm::length(place)),
        up_(place / radius_),
        along_(f64::perpendicular(up_)),
        across_(glm::cross(up_, along_)) {}

  [[nodiscard]] const glm::dvec3& up() const { return up_; }
  [[nodiscard]] double azimuth(const glm::dvec3& direction) const {
    return azimuth_of({glm::dot(direction, along_), glm::dot(direction, across_)});
  }

  // Tangent of how high a place of a radius stands over the level, a chord away from the direction of the eye.
  [[nodiscard]] double elevation(double radius, double chord) const {
    const double square = chord * chord;
    return (radius - radius_ - 0.5 * radius * square) / (radius * chord * std::sqrt(1.0 - 0.25 * square));
  }

  // The highest between two chords. A sphere below the eye rises towards its horizon; one above it sinks.
  [[nodiscard]] double highest(double radius, double nearest, double farthest) const {
    const double horizon = radius < radius_ ? std::sqrt(2.0 * (1.0 - radius / radius_)) : 0.0;
    return elevation(radius, std::clamp(horizon, nearest, farthest));
  }

  // The lowest between two chords.
  [[nodiscard]] double lowest(double radius, double nearest, double farthest) const {
    return std::min(elevation(radius, nearest), elevation(radius, farthest));
  }

 private:
  double radius_;
  glm::dvec3 up_, along_, across_;
};

// How high ground that is known so far stands in each direction: what lies behind it and nowhere higher is hidden.
class Skyline {
 public:
  // from, to: as azimuth_of counts, in any turn.
  [[nodiscard]] bool hides(double from, double to, double elevation) const {
    const auto last = static_cast<std::int64_t>(std::floor(to * each));
    for (auto c = static_cast<std::int64_t>(std::floor(from * each)); c <= last; ++c) {
      if (columns_[place(c)].whole <= elevation) return false;
    }
    return true;
  }

  // Ground all along.
  void add(double from, double to, double elevation) {
    const double begin = from * each, end = to * each;
    const auto first = static_cast<std::int64_t>(std::floor(begin)), last = static_cast<std::int64_t>(std::floor(end));
    if (first == last) return;  // too narrow to be told
    columns_[place(first)].add_right(begin - std::floor(begin), elevation);
    for (std::int64_t c = first + 1; c < last; ++c) columns_[place(c)].add_whole(elevation);
    columns_[place(last)].add_left(end - std::floor(end), elevation);
  }

 private:
  static constexpr std::int64_t count = 1024;  // a power of two
  static constexpr double each = count / 4.0;  // columns

  // Grounds end within it: two that meet or overlap there hide all of it.
  struct Column {
    double whole = nowhere;
    double left = nowhere, left_end = 0.0;
    double right = nowhere, right_begin = 1.0;

    void add_whole(double elevation) { whole = std::max(whole, elevation); }
    void add_left(double end, double elevation) {
      if (end >= right_begin) add_whole(std::min(elevation, right));
      if ((end < left_end || elevation < left) && left > whole) return;
      left = elevation;
      left_end = end;
    }
    void add_right(double begin, double elevation) {
      if (begin <= left_end) add_whole(std::min(elevation, left));
      if ((begin > right_begin || elevation < right) && right > whole) return;
      right = elevation;
      right_begin = begin;
    }
  };

  static std::size_t place(std::int64_t column) { return static_cast<std::size_t>(column & (count - 1)); }

  std::array<Column, count> columns_{};
};

// Radii of a node's highest and lowest that are drawn.
struct Radii {
  double top, bottom;
};

// As the eye sees it.
NodeSilhouette silhouette_of(const Eye& eye, const NodeOutline& outline, const Radii& radii) {
  constexpr double all_around = 0.3, far_away = 1.0;
  NodeSilhouette seen;
  seen.nearest = nearest_to(outline, eye.up());
  const double farthest = farthest_from(outline, eye.up());
  // The azimuth means nothing below the eye, and little far around the sphere.
  seen.is_known = outline.bulge < all_around * seen.nearest && farthest < far_away;
  if (!seen.is_known) return seen;
  const double middle = eye.azimuth(outline.middle) + 4.0;
  std::size_t from = 0, to = 0;
  std::array<double, 4> beside{};
  for (std::size_t i = 0; i < 4; ++i) {
    beside.at(i) = std::remainder(eye.azimuth(outline.corners.at(i)) - middle, 4.0);
    if (beside.at(i) < beside.at(from)) from = i;
    if (beside.at(i) > beside.at(to)) to = i;
  }
  seen.from = middle + beside.at(from);
  seen.to = middle + beside.at(to);
  seen.widened = 1.1 * outline.bulge / seen.nearest;
  seen.top = eye.highest(radii.top, seen.nearest, farthest);
  // Between the corners where it begins and ends the node is nowhere further from the line between them than its sides
  // bulge.
  const glm::dvec3 &a = outline.corners.at(from), &b = outline.corners.at(to);
  const double off = 0.125 * glm::dot(b - a, b - a) + outline.bulge;
  const double line = std::max(distance_to_line(eye.up(), a, b) - off, seen.nearest);
  seen.hidden_from = std::max(glm::distance(a, eye.up()), glm::distance(b, eye.up())) + outline.bulge;
  seen.bottom = eye.lowest(radii.bottom, line, seen.hidden_from);
  return seen;
}

}  // namespace

void leave_out_hidden(const NodeGrid& grid, const NodeSight& sight, int cells, const NodeCache& cache,
                      NodeSilhouettes& of_all, std::vector<DrawnNode>& drawn) {
  const Eye eye(sight.eye);
  auto& silhouettes = of_all.all;
  silhouettes.clear();
  for (const DrawnNode& node : drawn) {
    const NodeCache::Entry& entry = cache.at(node.slot);
    const NodeFrame& frame = entry.frame;
    // Flat triangles lie below the sphere of their corners.
    const double apart = 2.0 * grid.spacing(entry.node.level, cells);
    const double sea = sight.top_of_sea(frame.outline);
    NodeSilhouette seen = silhouette_of(
        eye, frame.outline,
        {std::max(1.0 + frame.shown.highest, sea), (1.0 + frame.shown.lowest) * (1.0 - 0.5 * apart * apart)});
    seen.drawn = node;
    silhouettes.push_back(seen);
  }
  auto& [nearest_first, hiding] = of_all.orders;
  nearest_first.clear();
  hiding.clear();
  for (std::size_t i = 0; i < silhouettes.size(); ++i) {
    nearest_first.emplace_back(silhouettes[i].nearest, i);
    if (silhouettes[i].is_known) hiding.emplace_back(silhouettes[i].hidden_from, i);
  }
  std::sort(nearest_first.begin(), nearest_first.end());
  std::sort(hiding.begin(), hiding.end());

  Skyline skyline;
  drawn.clear();
  std::size_t next = 0;
  for (const auto& [nearest, index] : nearest_first) {
    const NodeSilhouette& seen = silhouettes[index];
    for (; next < hiding.size() && hiding[next].first <= nearest; ++next) {
      const NodeSilhouette& before = silhouettes[hiding[next].second];
      skyline.add(before.from, before.to, before.bottom);
    }
    if (!seen.is_known || !skyline.hides(seen.from - seen.widened, seen.to + seen.widened, seen.top))
      drawn.push_back(seen.drawn);
  }
}

}  // namespace terrella
