#include "planet/icosphere_groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>

#include "laws/random_places.hpp"
#include "planet/terrain.hpp"
#include "scene/scene.hpp"

namespace terrella {
namespace {

std::vector<glm::vec3> hills(const Icosphere& sphere, int level) {
  const f32::Terrain terrain = terrain_of(Scene());
  std::vector<glm::vec3> positions;
  for (const glm::dvec3& d : sphere.directions)
    positions.emplace_back(d * ground_radius(terrain, d, icosphere_edge(level)));
  return positions;
}

TEST(VisibleGroups, LeaveOutNoneThatFacesTheEye) {
  test::Places places(2U);
  const Icosphere sphere = make_icosphere(group_level);
  const std::vector<float> tops(group_count, 1.1F);
  for (int i = 0; i < 60; ++i) {
    const double distance = i % 3 == 0 ? 1.0005 : i % 3 == 1 ? 1.3 : 40.0;
    const glm::dvec3 eye = distance * places.on_sphere();
    std::vector<bool> drawn(group_count);
    for (const std::uint32_t g : visible_groups({eye}, 1.0, tops)) drawn.at(g) = true;
    for (std::size_t g = 0; g < group_count; ++g) {
      for (std::size_t k = 0; k < 3; ++k) {
        // A mountain top is seen unless the unit sphere stands before it.
        const glm::dvec3 top = 1.1 * sphere.directions[sphere.indices[3 * g + k]];
        const glm::dvec3 ray = glm::normalize(top - eye);
        const double along = -glm::dot(eye, ray);
        const bool hidden = along > 0.0 && along < glm::distance(eye, top) && glm::length(eye + along * ray) < 1.0;
        if (!hidden) {
          ASSERT_TRUE(drawn[g]) << distance;
        }
      }
    }
    // As many as lie on the caps that the horizon and the mountains beyond it leave, and a rim of one group.
    const double reach = std::acos(1.0 / distance) + std::acos(1.0 / 1.1) + 2.0 * icosphere_edge(group_level);
    const double cap = 0.5 * (1.0 - std::cos(std::min(reach, std::numbers::pi)));
    EXPECT_LT(static_cast<double>(std::count(drawn.begin(), drawn.end(), true)), cap * group_count) << distance;
  }
}

TEST(VisibleGroups, LeaveOutWhatLiesBesideThePictureAndNothingInIt) {
  test::Places places(5U);
  const Icosphere sphere = make_icosphere(group_level);
  const std::vector<float> tops(group_count, 1.1F);
  for (int i = 0; i < 60; ++i) {
    const Sight sight = {(i % 2 == 0 ? 1.2 : 3.0) * places.on_sphere(), places.on_sphere(), 0.4};
    const std::vector<std::uint32_t> all = visible_groups({sight.eye}, 1.0, tops),
                                     seen = visible_groups(sight, 1.0, tops);
    EXPECT_LT(seen.size(), all.size());
    for (const std::uint32_t g : all) {
      bool inside = false;
      for (std::size_t k = 0; k < 3; ++k) {
        for (const double radius : {1.0, 1.05, 1.1}) {
          const glm::dvec3 place = radius * sphere.directions[sphere.indices[3 * std::size_t{g} + k]];
          inside = inside || glm::dot(glm::normalize(place - sight.eye), sight.forward) > std::cos(sight.half_angle);
        }
      }
      if (inside) {
        ASSERT_TRUE(std::binary_search(seen.begin(), seen.end(), g));
      }
    }
  }
}

TEST(VisibleGroups, LeaveOutWhatIsNotThere) {
  std::vector<float> tops(group_count, 0.0F);
  EXPECT_TRUE(visible_groups({{3.0, 0.0, 0.0}}, 1.0, tops).empty());
  tops[7] = 1.0F;
  const std::vector<std::uint32_t> only = {7};
  EXPECT_EQ(visible_groups({{0.0, 0.0, 0.5}}, 1.0, tops), only);  // from within
}

TEST(RadiusRanges, HoldTheSurface) {
  const int level = 6;
  const Icosphere sphere = make_icosphere(level);
  const std::vector<glm::vec3> positions = hills(sphere, level);
  const std::vector<RadiusRange> ranges = radius_ranges(sphere, positions);
  for (const double tolerance : {0.0, 1e-3, 0.1}) {
    const GroupedTriangles triangles = simplified(sphere, positions, tolerance);
    for (std::size_t g = 0; g < group_count; ++g) {
      for (std::size_t t = triangles.starts[g]; t < triangles.starts[g + 1]; ++t) {
        glm::dvec3 middle(0.0);
        for (std::size_t k = 0; k < 3; ++k) middle += glm::dvec3(positions[triangles.indices[3 * t + k]]) / 3.0;
        ASSERT_GE(glm::length(middle), ranges[g].lowest - 1e-7);
        ASSERT_LE(glm::length(middle), ranges[g].highest + 1e-7);
      }
    }
  }
}

TEST(Simplified, HasNoCrack) {
  const Icosphere sphere = make_icosphere(6);
  const std::vector<glm::vec3> positions = hills(sphere, 6);
  for (const double tolerance : {3e-4, 1e-3, 4e-3}) {
    const GroupedTriangles triangles = simplified(sphere, positions, tolerance);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
      for (std::size_t k = 0; k < 3; ++k) ++edges[{triangles.indices[i + k], triangles.indices[i + (k + 1) % 3]}];
    }
    for (const auto& [edge, count] : edges) {
      ASSERT_EQ(count, 1);
      ASSERT_EQ(edges.count({edge.second, edge.first}), 1U) << tolerance;
    }
    EXPECT_LT(triangles.indices.size(), sphere.indices.size()) << tolerance;
  }
}

TEST(Simplified, KeepsToItsTolerance) {
  const Icosphere sphere = make_icosphere(6);
  const std::vector<glm::vec3> positions = hills(sphere, 6);
  for (const double tolerance : {2e-4, 1e-3}) {
    const GroupedTriangles triangles = simplified(sphere, positions, tolerance);
    std::vector<bool> used(positions.size());
    for (const std::uint32_t i : triangles.indices) used[i] = true;
    double worst = 0.0;
    for (std::size_t g = 0; g < group_count; ++g) {
      for (std::size_t i = 48 * g; i < 48 * (g + 1); ++i) {
        const std::uint32_t v = sphere.indices[i];
        if (used[v]) continue;
        // How far the vertex stands off the plane of the triangle that its direction passes through.
        for (std::size_t t = triangles.starts[g]; t < triangles.starts[g + 1]; ++t) {
          const std::array<glm::dvec3, 3> p = {positions[triangles.indices[3 * t]],
                                               positions[triangles.indices[3 * t + 1]],
                                               positions[triangles.indices[3 * t + 2]]};
          const glm::dvec3 d = glm::normalize(glm::dvec3(positions[v]));
          const double inside = std::min({glm::dot(d, glm::cross(p[0], p[1])), glm::dot(d, glm::cross(p[1], p[2])),
                                          glm::dot(d, glm::cross(p[2], p[0]))});
          if (inside < 0.0) continue;
          const glm::dvec3 n = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
          worst = std::max(worst, std::abs(glm::dot(glm::dvec3(positions[v]) - p[0], n)));
          break;
        }
      }
    }
    EXPECT_GT(worst, 0.2 * tolerance);
    EXPECT_LT(worst, 2.5 * tolerance);
  }
}

TEST(Simplified, IsWholeWithoutTolerance) {
  const Icosphere sphere = make_icosphere(5);
  EXPECT_EQ(simplified(sphere, hills(sphere, 5), 0.0).indices, sphere.indices);
}

}  // namespace
}  // namespace terrella
