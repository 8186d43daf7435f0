#include "planet/icosphere_groups.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "base/check.hpp"

namespace terrella {
namespace {

// The cone around a group.
struct Cone {
  glm::dvec3 axis;    // unit
  double half_angle;  // rad
};

std::vector<Cone> make_cones() {
  const Icosphere sphere = make_icosphere(group_level);
  std::vector<Cone> cones;
  cones.reserve(group_count);
  for (std::size_t i = 0; i < sphere.indices.size(); i += 3) {
    const glm::dvec3 &a = sphere.directions[sphere.indices[i]], &b = sphere.directions[sphere.indices[i + 1]],
                     &c = sphere.directions[sphere.indices[i + 2]];
    const glm::dvec3 axis = glm::normalize(a + b + c);
    const double least_cosine = std::min({glm::dot(axis, a), glm::dot(axis, b), glm::dot(axis, c)});
    cones.push_back({axis, std::acos(least_cosine)});
  }
  return cones;
}

double arc_cosine(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); }

// Triangles of one level between the vertices of a finer icosphere, read off its indices.
class Hierarchy {
 public:
  struct Triangle {
    std::uint32_t a, b, c;
  };

  explicit Hierarchy(const Icosphere& sphere) : indices_(sphere.indices) {
    while ((std::size_t{60} << (2 * finest_)) < indices_.size()) ++finest_;
    CHECK(finest_ >= group_level && (std::size_t{60} << (2 * finest_)) == indices_.size(), indices_.size());
  }

  [[nodiscard]] int finest() const { return finest_; }

  // Triangle i of a level: its corners are those of its first, second and third child.
  [[nodiscard]] Triangle corners(int level, std::size_t i) const {
    std::size_t a = i, b = i, c = i;
    for (int l = level; l < finest_; ++l) {
      a = 4 * a;
      b = 4 * b + 1;
      c = 4 * c + 2;
    }
    return {indices_[3 * a], indices_[3 * b + 1], indices_[3 * c + 2]};
  }

  // The middles of its edges ab, bc, ca: the corners of its fourth child. level < finest().
  [[nodiscard]] Triangle middles(int level, std::size_t i) const { return corners(level + 1, 4 * i + 3); }

 private:
  std::span<const std::uint32_t> indices_;
  int finest_ = 0;
};

// Which vertices are needed as middles of edges.
std::vector<bool> needed_middles(const Hierarchy& tree, std::span<const glm::vec3> positions, double tolerance) {
  std::vector<bool> needed(positions.size());
  const auto tolerance2 = static_cast<float>(tolerance * tolerance);
  const auto far_from_edge = [&](std::uint32_t middle, std::uint32_t from, std::uint32_t to) {
    const glm::vec3 off = positions[middle] - 0.5F * (positions[from] + positions[to]);
    return glm::dot(off, off) > tolerance2;
  };
  const auto need = [&](const Hierarchy::Triangle& m) { needed[m.a] = needed[m.b] = needed[m.c] = true; };
  for (int level = tree.finest() - 1; level >= group_level; --level) {
    const std::size_t count = std::size_t{20} << (2 * level);
    for (std::size_t i = 0; i < count; ++i) {
      const auto t = tree.corners(level, i), m = tree.middles(level, i);
      if (far_from_edge(m.a, t.a, t.b) || far_from_edge(m.b, t.b, t.c) || far_from_edge(m.c, t.c, t.a)) need(m);
    }
    // A triangle that is split belongs to a parent that is split whole.
    for (std::size_t i = 0; i < count && level > group_level; ++i) {
      const auto m = tree.middles(level, i);
      if (needed[m.a] || needed[m.b] || needed[m.c]) need(tree.middles(level - 1, i / 4));
    }
  }
  return needed;
}

// Adds what is left of triangle i of a level.
void add_triangle(const Hierarchy& tree, const std::vector<bool>& needed, int level, std::size_t i,
                  std::vector<std::uint32_t>& indices) {
  const auto [a, b, c] = tree.corners(level, i);
  const auto add = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) { indices.insert(indices.end(), {p, q, r}); };
  if (level == tree.finest()) return add(a, b, c);
  const auto [ab, bc, ca] = tree.middles(level, i);
  const bool on_ab = needed[ab], on_bc = needed[bc], on_ca = needed[ca];
  if (on_ab && on_bc && on_ca) {
    for (std::size_t child = 0; child < 4; ++child) add_triangle(tree, needed, level + 1, 4 * i + child, indices);
    return;
  }
  // From a corner on, around to the middles that are there: a fan.
  const std::uint32_t corner = on_ab && on_bc   ? ab
                               : on_bc && on_ca ? bc
                               : on_ca && on_ab ? ca
                               : on_ab          ? ab
                               : on_bc          ? bc
                                                : ca;
  std::vector<std::uint32_t> rim = {a};
  if (on_ab) rim.push_back(ab);
  rim.push_back(b);
  if (on_bc) rim.push_back(bc);
  rim.push_back(c);
  if (on_ca) rim.push_back(ca);
  const bool whole = rim.size() == 3;
  std::rotate(rim.begin(), whole ? rim.begin() : std::find(rim.begin(), rim.end(), corner), rim.end());
  for (std::size_t k = 1; k + 1 < rim.size(); ++k) add(rim[0], rim[k], rim[k + 1]);
}

}  // namespace

GroupedTriangles all_triangles(const Icosphere& sphere) {
  const auto each = static_cast<std::uint32_t>(sphere.indices.size() / 3 / group_count);
  CHECK(each > 0, sphere.indices.size());
  GroupedTriangles all = {sphere.indices, {}};
  for (std::uint32_t g = 0; g <= group_count; ++g) all.starts.push_back(g * each);
  return all;
}

GroupedTriangles simplified(const Icosphere& sphere, std::span<const glm::vec3> positions, double tolerance) {
  if (tolerance <= 0.0) return all_triangles(sphere);
  const Hierarchy tree(sphere);
  const std::vector<bool> needed = needed_middles(tree, positions, tolerance);
  GroupedTriangles left = {{}, {0}};
  for (std::size_t g = 0; g < group_count; ++g) {
    add_triangle(tree, needed, group_level, g, left.indices);
    left.starts.push_back(static_cast<std::uint32_t>(left.indices.size() / 3));
  }
  return left;
}

double icosphere_sag(int level) {
  // The middle of a triangle is at most an edge over the square root of 3 away from its corners.
  const double edge = icosphere_edge(level);
  return edge * edge / 6.0;
}

std::vector<RadiusRange> radius_ranges(const Icosphere& sphere, std::span<const glm::vec3> positions) {
  CHECK(positions.size() == sphere.directions.size(), positions.size());
  const std::size_t each = sphere.indices.size() / group_count;
  CHECK(each > 0, sphere.indices.size());
  std::vector<RadiusRange> ranges;
  ranges.reserve(group_count);
  for (std::size_t g = 0; g < group_count; ++g) {
    float lowest2 = std::numeric_limits<float>::max(), highest2 = 0.0F;
    for (const std::uint32_t i : std::span(sphere.indices).subspan(g * each, each)) {
      const float radius2 = glm::dot(positions[i], positions[i]);
      lowest2 = std::min(lowest2, radius2);
      highest2 = std::max(highest2, radius2);
    }
    // The largest triangle that may be drawn is the group's own.
    ranges.push_back({(1.0 - icosphere_sag(group_level)) * std::sqrt(lowest2), std::sqrt(highest2)});
  }
  return ranges;
}

std::vector<std::uint32_t> visible_groups(const Sight& sight, double occluder, std::span<const float> tops) {
  CHECK(tops.size() == group_count, tops.size());
  static const std::vector<Cone> cones = make_cones();
  const double distance = glm::length(sight.eye);
  std::vector<std::uint32_t> groups;
  if (distance <= occluder) {
    for (std::uint32_t g = 0; g < group_count; ++g) {
      if (tops[g] > 0.0F) groups.push_back(g);
    }
    return groups;
  }
  const double horizon = arc_cosine(occluder / distance);
  for (std::uint32_t g = 0; g < group_count; ++g) {
    const auto top = static_cast<double>(tops[g]);
    if (top <= 0.0) continue;
    const auto& [axis, half_angle] = cones[g];
    // A ball around all between occluder and top, from its middle: beside the planes? That is the quickest to tell.
    const glm::dvec3 to_middle = 0.5 * (occluder + top) * axis - sight.eye;
    const double ball = 0.5 * std::abs(top - occluder) + std::max(top, occluder) * half_angle;
    const auto& [low, high] = sight.sides;
    if (glm::dot(low, to_middle) < -ball || glm::dot(high, to_middle) < -ball) continue;
    // Beyond the horizon, by more than what rises there still shows over it.
    const double away = arc_cosine(glm::dot(axis, sight.eye) / distance) - half_angle;
    if (away > horizon && away > horizon + arc_cosine(occluder / top)) continue;
    // Beside the picture.
    const double far = glm::length(to_middle);
    const double beside =
        far > ball ? arc_cosine(glm::dot(to_middle, sight.forward) / far) - std::asin(ball / far) : 0.0;
    if (beside <= sight.half_angle) groups.push_back(g);
  }
  return groups;
}

}  // namespace terrella
