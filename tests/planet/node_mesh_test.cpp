#include "planet/node_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>

#include "laws/random_places.hpp"
#include "planet/terrain.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)), 1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
}

class Cells : public testing::TestWithParam<int> {};

TEST_P(Cells, FaceOutwardsAndCoverTheSphere) {
  const int cells = GetParam();
  for (unsigned coarser = 0; coarser < 16; ++coarser) {
    double covered = 0.0;
    for (int face = 0; face < 6; ++face) {
      const QuadNode node = {face, 0, 0, 0};
      const std::vector<std::uint16_t> indices = node_triangles(cells, coarser, false);
      const auto at = [&](std::size_t k) {
        return vertex_direction(node, indices[k] % (cells + 1), indices[k] / (cells + 1), cells);
      };
      for (std::size_t k = 0; k < indices.size(); k += 3) {
        const double part = solid_angle(at(k), at(k + 1), at(k + 2));
        EXPECT_GT(part, 0.0);
        covered += part;
      }
    }
    EXPECT_NEAR(covered, 4.0 * std::numbers::pi, 1e-9) << coarser;
  }
}

TEST_P(Cells, LeaveOutEverySecondVertexBesideCoarserNodes) {
  const int cells = GetParam();
  for (unsigned coarser = 0; coarser < 16; ++coarser) {
    std::map<std::pair<int, int>, int> edges;
    const auto count_edges = [&](const std::vector<std::uint16_t>& indices) {
      edges.clear();
      for (std::size_t k = 0; k < indices.size(); k += 3) {
        for (std::size_t n = 0; n < 3; ++n) ++edges[{indices[k + n], indices[k + (n + 1) % 3]}];
      }
      // What only one triangle has is the rim.
      int rim = 0;
      for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        if (!edges.contains({edge.second, edge.first})) ++rim;
      }
      return rim;
    };
    const int rim = 4 * cells - std::popcount(coarser) * cells / 2;
    EXPECT_EQ(count_edges(node_triangles(cells, coarser, false)), rim);
    // A skirt goes on where the node ends, so that only its own lower edge is left.
    EXPECT_EQ(count_edges(node_triangles(cells, coarser, true)), rim);
    for (const auto& [edge, count] : edges) {
      if (!edges.contains({edge.second, edge.first})) {
        EXPECT_GE(std::min(edge.first, edge.second), vertices_a_node(cells));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(NodeTriangles, Cells, testing::Values(8, 14, 20, 28));

glm::dvec3 place_of(const NodeFrame& frame, const NodeVertices& vertices, std::size_t n, double part) {
  return (1.0 + frame.base) * frame.middle +
         glm::dvec3(glm::dvec4(vertices.place[n]) + part * glm::dvec4(vertices.coarser[n]));
}

// The shape that a node takes on is the parent's: exactly at common vertices, and else on its flat triangles. What is
// left is the rounding to single precision of numbers as large as the node.
TEST(NodeMesh, TakesOnTheShapeOfItsParent) {
  constexpr int cells = 28;
  test::Places places(6);
  const f64::Terrain terrain = exact_terrain_of(find_preset("alps")->scene);
  for (const int level : {1, 4, 9, 15, 22}) {
    const QuadNode node = node_at(places.on_sphere(), level);
    NodeVertices fine, above;
    const NodeFrame fine_frame = make_node(node, cells, terrain, fine);
    const NodeFrame above_frame = make_node(parent_of(node), cells, terrain, above);
    const int first_i = node.x % 2 == 0 ? 0 : cells / 2, first_j = node.y % 2 == 0 ? 0 : cells / 2;
    const auto of_parent = [&](int i, int j) {
      return place_of(above_frame, above, static_cast<std::size_t>((first_j + j / 2) * (cells + 1) + first_i + i / 2),
                      0.0);
    };
    for (int j = 0; j <= cells; ++j) {
      for (int i = 0; i <= cells; ++i) {
        const glm::dvec3 taken_on = place_of(fine_frame, fine, static_cast<std::size_t>(j * (cells + 1) + i), 1.0);
        const glm::dvec3 expected = 0.5 * (of_parent(i, j) + of_parent(i + i % 2, j + j % 2));
        EXPECT_LT(glm::distance(taken_on, expected), 1e-15 + 3e-7 * node_edge(level)) << level;
      }
    }
  }
}

// Within a twentieth of a pixel wherever a node is drawn: it is seen from as far as 1.75 of its edges at the nearest,
// from where a pixel of 60 degrees in 1080 is a thousandth of a radian.
TEST(NodeMesh, HasTheTrueHeightsInSinglePrecision) {
  test::Places places(7);
  for (const char* name : {"temperate", "alps"}) {
    Scene scene = find_preset(name)->scene;
    scene.planet.radius = 6.36e6;
    scene.terrain.height = 9000.0;
    scene.terrain.octaves = 30;
    const f64::Terrain terrain = exact_terrain_of(scene);
    for (const int level : {0, 6, 12, 20, 26}) {
      for (const int cells : {8, 28}) {
        const QuadNode node = node_at(places.on_sphere(), level);
        NodeVertices vertices;
        const NodeFrame frame = make_node(node, cells, terrain, vertices);
        const double pixel = 1e-3 * 1.75 * node_edge(level);
        for (int n = 0; n < vertices_a_node(cells); ++n) {
          const glm::dvec3 direction = vertex_direction(node, n % (cells + 1), n / (cells + 1), cells);
          const double height = f64::terrain_height_at(direction, terrain, vertex_spacing(level, cells)).value;
          const glm::dvec3 place = place_of(frame, vertices, static_cast<std::size_t>(n), 0.0);
          EXPECT_LT(glm::distance(place, (1.0 + height) * direction), 0.05 * pixel) << name << " " << level;
          EXPECT_GE(height, frame.heights.lowest);
          EXPECT_LE(height, frame.heights.highest);
          EXPECT_LE(glm::distance(direction, frame.middle), frame.half_width * (1.0 + 1e-9));
        }
      }
    }
  }
}

// What pixels scale their layers by is held in half floats, which lose what is below 1e-5.
TEST(NodeMesh, TellsHowLayersRiseOnTheLowestGroundAsOnTheHighest) {
  f64::Terrain low = exact_terrain_of(find_preset("blue")->scene), high = low;
  low.height = 1e-7;
  high.height = 1e-3;
  const QuadNode node = {0, 3, 2, 5};
  NodeVertices of_low, of_high;
  make_node(node, 8, low, of_low);
  make_node(node, 8, high, of_high);
  float most = 0.0F;
  for (std::size_t n = 0; n < of_low.rise.size(); ++n) {
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(of_low.rise[n][k], of_high.rise[n][k], 1e-5) << n;
    most = std::max(most, of_low.rise[n].x);
  }
  EXPECT_GT(most, 0.1F);
}

}  // namespace
}  // namespace terrella
