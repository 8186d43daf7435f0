#include "planet/node_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>

#include "planet/grids.hpp"
#include "planet/terrain.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)), 1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
}

struct Patch {
  test::Grid grid;
  int cells;
};

void PrintTo(const Patch& patch, std::ostream* out) { *out << patch.grid << patch.cells; }

class NodePatches : public testing::TestWithParam<Patch> {
 protected:
  const std::shared_ptr<const NodeGrid> grid = test::grid_for(GetParam().grid);
  const NodePatch patch = grid->patch(GetParam().cells);
};

// All of it, or as much as a grid around an eye is to reach.
TEST_P(NodePatches, FaceOutwardsAndCoverTheSphere) {
  double whole = 0.0;
  for (unsigned coarser = 0; coarser < patch.lists(); ++coarser) {
    double covered = 0.0;
    for (const GridNode& node : grid->roots()) {
      const std::vector<std::uint16_t> indices = node_triangles(patch, coarser, false);
      const std::vector<glm::dvec3> at = test::directions_of(*grid, patch, node);
      for (std::size_t k = 0; k < indices.size(); k += 3) {
        const double part = solid_angle(at[indices[k]], at[indices[k + 1]], at[indices[k + 2]]);
        EXPECT_GT(part, 0.0);
        covered += part;
      }
      if (coarser == patch.list_of_every_second()) {
        EXPECT_EQ(4 * indices.size(), patch.triangles.size());
      }
    }
    if (coarser == 0) whole = test::covers_sphere(GetParam().grid) ? 4.0 * std::numbers::pi : covered;
    EXPECT_NEAR(covered, whole, test::covers_sphere(GetParam().grid) ? 1e-9 : 0.05 * whole) << coarser;
  }
  EXPECT_GT(whole, 1.0);
}

TEST_P(NodePatches, LeaveOutEverySecondVertexBesideCoarserNodes) {
  for (unsigned coarser = 0; coarser < patch.lists(); ++coarser) {
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
    const bool every_second = coarser == patch.list_of_every_second();
    const int left_out = every_second ? static_cast<int>(patch.sides) : std::popcount(coarser);
    const int rim = static_cast<int>(patch.sides) * patch.cells - left_out * patch.cells / 2;
    EXPECT_EQ(count_edges(node_triangles(patch, coarser, false)), rim);
    // A skirt goes on where the node ends, so that only its own lower edge is left.
    EXPECT_EQ(count_edges(node_triangles(patch, coarser, true)), rim);
    for (const auto& [edge, count] : edges) {
      if (!edges.contains({edge.second, edge.first})) {
        EXPECT_GE(std::min(edge.first, edge.second), std::ssize(patch.vertices));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfGrids, NodePatches,
                         testing::Values(Patch{test::Grid::cube, 8}, Patch{test::Grid::cube, 14},
                                         Patch{test::Grid::cube, 28}, Patch{test::Grid::icosahedron, 8},
                                         Patch{test::Grid::icosahedron, 14}, Patch{test::Grid::icosahedron, 28},
                                         Patch{test::Grid::persistent, 20}),
                         testing::PrintToStringParamName());

class NodeMeshes : public testing::TestWithParam<test::Grid> {
 protected:
  const std::shared_ptr<const NodeGrid> grid = test::grid_for(GetParam());
};

INSTANTIATE_TEST_SUITE_P(OfGrids, NodeMeshes, test::all_grids, testing::PrintToStringParamName());

glm::dvec3 place_of(const NodeFrame& frame, const NodeVertices& vertices, std::size_t n, double part) {
  return (1.0 + frame.base) * frame.outline.middle +
         glm::dvec3(glm::dvec4(vertices.place[n]) + part * glm::dvec4(vertices.coarser[n]));
}

// The shape that a node takes on is the parent's: exactly at common vertices, and else on its flat triangles. What is
// left is the rounding to single precision of numbers as large as the node.
TEST_P(NodeMeshes, TakeOnTheShapeOfTheirParents) {
  const NodePatch patch = grid->patch(28);
  test::Places places(6);
  const f64::Terrain terrain = exact_terrain_of(find_preset("alps")->scene);
  for (const int level : {1, 4, 9, 15, 22}) {
    const GridNode node = test::random_node(*grid, places, level), parent = grid->parent_of(node);
    NodeVertices fine, above;
    const NodeFrame fine_frame = make_node(*grid, patch, node, terrain, fine);
    const NodeFrame above_frame = make_node(*grid, patch, parent, terrain, above);
    const std::vector<glm::dvec3> own = test::directions_of(*grid, patch, node),
                                  theirs = test::directions_of(*grid, patch, parent);
    const auto of_parent = [&](std::size_t n) {
      const auto found = static_cast<std::size_t>(std::find(theirs.begin(), theirs.end(), own[n]) - theirs.begin());
      EXPECT_LT(found, theirs.size());
      return place_of(above_frame, above, found, 0.0);
    };
    for (std::size_t n = 0; n < own.size(); ++n) {
      const glm::dvec3 taken_on = place_of(fine_frame, fine, n, 1.0);
      const glm::dvec3 expected = 0.5 * (of_parent(patch.vertices[n].from) + of_parent(patch.vertices[n].to));
      EXPECT_LT(glm::distance(taken_on, expected), 1e-15 + 3e-7 * grid->edge(level)) << level;
    }
  }
}

// Within a twentieth of a pixel wherever a node is drawn: it is seen from as far as 1.33 of its edges at the nearest,
// from where a pixel of 60 degrees in 1080 is a thousandth of a radian.
TEST_P(NodeMeshes, HaveTheTrueHeightsInSinglePrecision) {
  test::Places places(7);
  for (const char* name : {"temperate", "alps"}) {
    Scene scene = find_preset(name)->scene;
    scene.planet.radius = 6.36e6;
    scene.terrain.height = 9000.0;
    scene.terrain.octaves = 30;
    const f64::Terrain terrain = exact_terrain_of(scene);
    for (const int level : {0, 6, 12, 20, 26}) {
      for (const int cells : {8, 28}) {
        const NodePatch patch = grid->patch(cells);
        const GridNode node = test::random_node(*grid, places, level);
        NodeVertices vertices;
        const NodeFrame frame = make_node(*grid, patch, node, terrain, vertices);
        const double pixel = 1e-3 * 1.33 * grid->edge(level);
        const std::vector<glm::dvec3> directions = test::directions_of(*grid, patch, node);
        for (std::size_t n = 0; n < directions.size(); ++n) {
          const glm::dvec3& direction = directions[n];
          const double height = f64::terrain_height_at(direction, terrain, grid->spacing(level, cells)).value;
          const glm::dvec3 place = place_of(frame, vertices, n, 0.0);
          EXPECT_LT(glm::distance(place, (1.0 + height) * direction), 0.05 * pixel) << name << " " << level;
          EXPECT_GE(height, frame.heights.lowest);
          EXPECT_LE(height, frame.heights.highest);
          EXPECT_LE(glm::distance(direction, frame.outline.middle), frame.outline.half_width * (1.0 + 1e-9));
        }
      }
    }
  }
}

// Pixels add to the means that a smoother ground is made of.
TEST(NodeMesh, TellsTheMeansOfTheGroundThatPixelsGoOnWith) {
  const f64::Terrain terrain = exact_terrain_of(find_preset("blue")->scene);
  const CubeGrid grid;
  const NodePatch patch = grid.patch(8);
  const GridNode node = {0, 3, 2, 5};
  NodeVertices vertices;
  make_node(grid, patch, node, terrain, vertices);
  const double footprint = f64::held_footprint(grid.spacing(node.level, patch.cells));
  const std::vector<glm::dvec3> directions = test::directions_of(grid, patch, node);
  for (std::size_t n = 0; n < vertices.means.size(); ++n) {
    const glm::dvec4 means = vertices.means[n];
    const double height = f64::terrain_height_at(directions[n], terrain, footprint).value;
    EXPECT_NEAR(f64::relief_of(terrain, means.x, means.y).value, height, 1e-6 * terrain.height) << n;
  }
}

// What of their slopes comes of which mean: each changes in another way where pixels add to both.
TEST(NodeMesh, TellsWhatOfItsSlopesComesOfRanges) {
  const f64::Terrain terrain = exact_terrain_of(find_preset("blue")->scene);
  const CubeGrid grid;
  const NodePatch patch = grid.patch(8);
  NodeVertices vertices;
  double steepest = 0.0;
  for (std::uint32_t x = 4; x < 256; x += 24) {
    const GridNode node = {0, 8, x, 150};
    make_node(grid, patch, node, terrain, vertices);
    const double footprint = f64::held_footprint(grid.spacing(node.level, patch.cells));
    const std::vector<glm::dvec3> directions = test::directions_of(grid, patch, node);
    for (std::size_t n = 0; n < directions.size(); ++n) {
      const glm::dvec3 up = directions[n], along = f64::perpendicular(up);
      const auto shape_at = [&](double aside) {
        return f64::terrain_height_at(glm::normalize(up + aside * along), terrain, footprint).shape;
      };
      constexpr double step = 1e-7;
      const double by_shape = f64::relief_of(terrain, vertices.means[n].x, vertices.means[n].y).by_shape;
      const double slope = by_shape * (shape_at(step) - shape_at(-step)) / (2.0 * step);
      if (vertices.means[n].y >= 4.0F) continue;  // ice
      EXPECT_NEAR(glm::dot(glm::dvec3(vertices.shape_slope[n]), along), slope, 1e-6);
      steepest = std::max(steepest, std::abs(slope));
    }
  }
  EXPECT_GT(steepest, 1e-4);
}

// Half of it is where a vertex is midway between one that is ice and one that is not.
TEST(NodeMesh, TellsIceByAFlagOnTheShape) {
  const f64::Terrain terrain = exact_terrain_of(find_preset("blue")->scene);
  const CubeGrid grid;
  const NodePatch patch = grid.patch(28);
  NodeVertices vertices;
  int iced = 0, halves = 0;
  for (const std::uint32_t x : {3U, 4U}) {
    const GridNode node = {4, 3, x, 3};
    make_node(grid, patch, node, terrain, vertices);
    const std::vector<glm::dvec3> directions = test::directions_of(grid, patch, node);
    for (std::size_t n = 0; n < directions.size(); ++n) {
      const bool is_ice = f64::terrain_height_at(directions[n], terrain, grid.spacing(node.level, 28)).iced;
      const float own = vertices.means[n].y, above = own + vertices.means[n].w;
      EXPECT_EQ(own >= 4.0F, is_ice);
      iced += is_ice ? 1 : 0;
      halves += above > 3.9F && above < 7.9F ? 1 : 0;
    }
  }
  EXPECT_GT(iced, 100);
  EXPECT_GT(halves, 3);
}

}  // namespace
}  // namespace terrella
