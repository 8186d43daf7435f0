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

}  // namespace

double icosphere_sag(int level) {
  // The middle of a triangle is at most an edge over the square root of 3 away from its corners.
  const double edge = icosphere_edge(level);
  return edge * edge / 6.0;
}

std::vector<RadiusRange> radius_ranges(const Icosphere& sphere, int level, std::span<const glm::vec3> positions) {
  CHECK(level >= group_level && positions.size() == sphere.directions.size(), level, positions.size());
  const std::size_t each = sphere.indices.size() / group_count;
  std::vector<RadiusRange> ranges;
  ranges.reserve(group_count);
  for (std::size_t g = 0; g < group_count; ++g) {
    float lowest2 = std::numeric_limits<float>::max(), highest2 = 0.0F;
    for (const std::uint32_t i : std::span(sphere.indices).subspan(g * each, each)) {
      const float radius2 = glm::dot(positions[i], positions[i]);
      lowest2 = std::min(lowest2, radius2);
      highest2 = std::max(highest2, radius2);
    }
    ranges.push_back({(1.0 - icosphere_sag(level)) * std::sqrt(lowest2), std::sqrt(highest2)});
  }
  return ranges;
}

std::vector<TriangleRun> visible_triangles(int level, const glm::dvec3& eye, double occluder, std::span<const float> tops) {
  CHECK(level >= group_level && tops.size() == group_count, level, tops.size());
  static const std::vector<Cone> cones = make_cones();
  const std::uint32_t each = 1U << (2 * (level - group_level));
  const double distance = glm::length(eye);
  const bool outside = distance > occluder;
  const double horizon = outside ? arc_cosine(occluder / distance) : 0.0;
  std::vector<TriangleRun> runs;
  for (std::uint32_t g = 0; g < group_count; ++g) {
    const auto top = static_cast<double>(tops[g]);
    if (top <= 0.0) continue;
    if (outside) {
      // Beyond the horizon, by more than what rises there still shows over it.
      const double away = arc_cosine(glm::dot(cones[g].axis, eye) / distance) - cones[g].half_angle;
      if (away > horizon && away > horizon + arc_cosine(occluder / top)) continue;
    }
    if (!runs.empty() && runs.back().end == g * each) {
      runs.back().end += each;
    } else {
      runs.push_back({g * each, (g + 1) * each});
    }
  }
  return runs;
}

}  // namespace terrella
