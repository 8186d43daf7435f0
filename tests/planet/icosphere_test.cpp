#include "planet/icosphere.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include <glm/geometric.hpp>

#include "laws/random_places.hpp"

namespace terrella {
namespace {

TEST(Icosphere, HasTheStatedNumbersOfTrianglesAndSharedVertices) {
  for (int level = 0; level <= 5; ++level) {
    const Icosphere sphere = make_icosphere(level);
    const std::size_t quads = std::size_t{1} << (2 * level);
    EXPECT_EQ(sphere.indices.size(), 60 * quads);
    EXPECT_EQ(sphere.directions.size(), 10 * quads + 2);
  }
}

TEST(Icosphere, IsClosedWithoutACrack) {
  const Icosphere sphere = make_icosphere(4);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t i = 0; i < sphere.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{sphere.indices[i + k], sphere.indices[i + (k + 1) % 3]}];
  }
  // Each edge is walked once in each direction: two triangles share it, and both face the same way.
  for (const auto &[edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
}

TEST(Icosphere, FacesOutwardsAndCoversTheSphere) {
  const Icosphere sphere = make_icosphere(4);
  double solid_angle = 0.0;
  for (std::size_t i = 0; i < sphere.indices.size(); i += 3) {
    const glm::dvec3 &a = sphere.directions[sphere.indices[i]], &b = sphere.directions[sphere.indices[i + 1]],
                     &c = sphere.directions[sphere.indices[i + 2]];
    const double volume = glm::dot(a, glm::cross(b, c));
    ASSERT_GT(volume, 0.0);
    solid_angle += 2.0 * std::atan2(volume, 1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
  }
  EXPECT_NEAR(solid_angle, 4.0 * std::numbers::pi, 1e-9);
}

TEST(Icosphere, EdgeIsTheLongestEdge) {
  for (int level = 0; level <= 6; ++level) {
    const Icosphere sphere = make_icosphere(level);
    double longest = 0.0;
    for (std::size_t i = 0; i < sphere.indices.size(); i += 3) {
      const glm::dvec3 &a = sphere.directions[sphere.indices[i]], &b = sphere.directions[sphere.indices[i + 1]];
      longest = std::fmax(longest, 2.0 * std::asin(0.5 * glm::distance(a, b)));
    }
    EXPECT_NEAR(icosphere_edge(level), longest, 2e-6) << level;
  }
}

TEST(LocateOnIcosphere, FindsTheTriangleThatADirectionPassesThrough) {
  test::Places places(1U);
  for (int i = 0; i < 3000; ++i) {
    const glm::dvec3 d = places.on_sphere();
    const IcospherePlace place = locate_on_icosphere(d, 6);
    glm::dvec3 point(0.0);
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(place.weights[k], -1e-9);
      point += place.weights[k] * place.corners[static_cast<std::size_t>(k)];
    }
    EXPECT_LT(glm::distance(glm::normalize(point), d), 1e-12);
    EXPECT_LT(glm::distance(place.corners[0], place.corners[1]), icosphere_edge(6) + 1e-6);
  }
}

}  // namespace
}  // namespace terrella
