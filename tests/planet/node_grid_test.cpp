#include "planet/node_grid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "formulas/formulas.hpp"
#include "planet/grids.hpp"

namespace terrella {
namespace {

using test::Places;

constexpr int kCells = 28;

using Directions = std::set<glm::dvec3, test::LessDirection>;

class NodeGrids : public testing::TestWithParam<test::Grid> {
 protected:
  const std::shared_ptr<const NodeGrid> grid = test::grid_for(GetParam());
  const NodePatch patch = grid->patch(kCells);

  [[nodiscard]] Directions all_of(const GridNode& node) const {
    const std::vector<glm::dvec3> list = test::directions_of(*grid, patch, node);
    return {list.begin(), list.end()};
  }
};

TEST_P(NodeGrids, QuarterANode) {
  Places places(2);
  for (const int level : {0, 1, 2, 5, deepest_level - 1}) {
    for (int n = 0; n < 20; ++n) {
      const GridNode node = test::random_node(*grid, places, level);
      const auto children = grid->children_of(node);
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(children.at(k).level, level + 1);
        EXPECT_EQ(grid->parent_of(children.at(k)), node);
        for (std::size_t i = 0; i < k; ++i) EXPECT_FALSE(children.at(k) == children.at(i));
        EXPECT_LT(glm::distance(grid->middle_of(children.at(k)), grid->middle_of(node)), 0.6 * grid->edge(level));
      }
    }
  }
}

// So that nodes of different levels have whole vertices in common.
TEST_P(NodeGrids, HaveTheSameVerticesWhateverTheLevel) {
  Places places(3);
  for (const int level : {1, 2, 8, 20, deepest_level}) {
    for (int n = 0; n < 8; ++n) {
      const GridNode node = test::random_node(*grid, places, level);
      const Directions above = all_of(grid->parent_of(node));
      const std::vector<glm::dvec3> own = test::directions_of(*grid, patch, node);
      for (std::size_t k = 0; k < own.size(); ++k)
        EXPECT_EQ(above.contains(own[k]), patch.vertices[k].from == k) << level << " " << k;
    }
  }
}

// What a vertex between those of the level above is halfway between.
TEST_P(NodeGrids, LieBetweenVerticesOfTheLevelAbove) {
  Places places(4);
  const GridNode node = test::random_node(*grid, places, 12);
  const std::vector<glm::dvec3> own = test::directions_of(*grid, patch, node);
  for (std::size_t k = 0; k < own.size(); ++k) {
    const glm::dvec3 middle = 0.5 * (own[patch.vertices[k].from] + own[patch.vertices[k].to]);
    EXPECT_LT(glm::distance(own[k], middle), 0.01 * grid->spacing(12, kCells)) << k;
  }
}

// The bits of what is shared are those of the vertices that both have.
TEST_P(NodeGrids, KnowWhatLiesAround) {
  Places places(5);
  for (int n = 0; n < 300; ++n) {
    // On the first levels nearly every side is that of a face.
    const GridNode node = test::random_node(*grid, places, n % 30);
    const std::vector<glm::dvec3> own = test::directions_of(*grid, patch, node);
    for (const NodeBeside& beside : grid->around(node)) {
      EXPECT_EQ(beside.node.level, node.level);
      const Directions theirs = all_of(beside.node);
      for (std::size_t k = 0; k < own.size(); ++k) {
        if ((patch.vertices[k].touches & beside.shares) != 0) {
          EXPECT_TRUE(theirs.contains(own[k])) << node.face << "/" << node.level << ": " << node.x << ", " << node.y;
        }
      }
    }
  }
}

// Of all nodes of a level: whichever have a vertex in common know of each other.
TEST_P(NodeGrids, ForgetNoneOfThoseAround) {
  using Key = std::tuple<int, std::uint32_t, std::uint32_t>;
  const auto key_of = [](const GridNode& node) { return Key{node.face, node.x, node.y}; };
  const NodePatch coarse = grid->patch(2);
  std::vector<GridNode> level(grid->roots().begin(), grid->roots().end());
  for (int n = 0; n < 3; ++n) {
    std::vector<GridNode> next;
    for (const GridNode& node : level) {
      for (const GridNode& child : grid->children_of(node)) next.push_back(child);
    }
    level = next;
  }
  std::map<glm::dvec3, std::set<Key>, test::LessDirection> at;
  for (const GridNode& node : level) {
    for (const glm::dvec3& direction : test::directions_of(*grid, coarse, node)) at[direction].insert(key_of(node));
  }
  for (const GridNode& node : level) {
    std::set<Key> expected, told;
    for (const glm::dvec3& direction : test::directions_of(*grid, coarse, node))
      expected.insert(at[direction].begin(), at[direction].end());
    expected.erase(key_of(node));
    for (const NodeBeside& beside : grid->around(node)) told.insert(key_of(beside.node));
    EXPECT_EQ(told, expected);
  }
}

TEST_P(NodeGrids, TellHowLongSidesAreAtTheMost) {
  Places places(6);
  double longest = 0.0;
  for (int n = 0; n < 600; ++n) {
    const int level = n % 8;
    const GridNode node = test::random_node(*grid, places, level);
    const std::vector<glm::dvec3> own = test::directions_of(*grid, patch, node);
    for (std::size_t k = 0; k < patch.rim.size(); ++k) {
      const double side = glm::distance(own[patch.rim[k]], own[patch.rim[(k + 1) % patch.rim.size()]]);
      longest = std::max(longest, side / grid->spacing(level, kCells));
    }
  }
  // Of a face's middle sides are rarely those of a node that is taken at random.
  EXPECT_LE(longest, 1.0);
  EXPECT_GT(longest, 0.93);
}

INSTANTIATE_TEST_SUITE_P(OnSphere, NodeGrids, test::all_grids, testing::PrintToStringParamName());

TEST(CubeGrid, FindsTheNodeThatHoldsADirection) {
  const CubeGrid grid;
  Places places(1);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 direction = places.on_sphere();
    const GridNode deep = grid.node_at(direction, deepest_level);
    // Within a diagonal of the middle, which the angle of so small a chord is.
    EXPECT_LT(glm::distance(grid.middle_of(deep), direction), 0.71 * grid.edge(deepest_level));
    EXPECT_EQ(grid.parent_of(deep), grid.node_at(direction, deepest_level - 1));
    EXPECT_EQ(grid.node_at(grid.middle_of(grid.node_at(direction, 7)), 7), grid.node_at(direction, 7));
  }
}

// As far as any terrain can be seen, from its own eye and from others.
TEST(PersistentGrid, ReachesAllThatCanBeSeen) {
  Places places(7);
  for (int n = 0; n < 200; ++n) {
    const double top = n % 3 == 0 ? 0.0 : std::pow(10.0, places.between(-6.0, -0.7));
    const glm::dvec3 eye = (1.0 + std::pow(10.0, places.between(-7.0, 3.0))) * places.on_sphere();
    const PersistentGrid grid(eye, top);
    EXPECT_TRUE(grid.serves(eye, top));
    const glm::dvec3 other = eye + 0.2 * (glm::length(eye) - 1.0) * places.in_cube(1.0);
    EXPECT_TRUE(grid.reaches(other, top) || !grid.serves(other, top));
    const glm::dvec3 reached = grid.reaches(other, top) ? other : eye;
    const double far = f64::hidden_angle(1.0, glm::length(reached) - 1.0, top);
    // No place of the rim is nearer to what lies below the eye.
    const NodePatch patch = grid.patch(kCells);
    for (const std::uint16_t k : patch.rim) {
      const glm::dvec3 rim = grid.vertex_direction({}, patch.vertices[k].i, patch.vertices[k].j, kCells);
      EXPECT_GE(f64::angle_between(rim, reached), far) << top << " " << glm::length(eye) - 1.0;
    }
  }
}

TEST(PersistentGrid, IsMadeAnewWhereItWouldBeMuchSmaller) {
  const glm::dvec3 up(0.0, 0.6, 0.8);
  const PersistentGrid grid(1.5 * up, 1e-3);
  EXPECT_TRUE(grid.serves(1.3 * up, 1e-3));
  EXPECT_FALSE(grid.serves(1.5 * up, 0.2));
  EXPECT_FALSE(grid.serves(1.2 * up, 1e-3));
  EXPECT_FALSE(grid.serves(1.9 * up, 1e-3));
  EXPECT_FALSE(grid.serves(1.5 * glm::dvec3(0.0, 0.8, 0.6), 1e-3));
}

// While an eye leaves it there is time to make the next one and to let it take its place.
TEST(PersistentGrid, ReachesFurtherThanItServes) {
  const glm::dvec3 up(0.0, 0.6, 0.8);
  for (const double altitude : {1e-6, 1e-3, 1.0}) {
    const PersistentGrid grid((1.0 + altitude) * up, 1e-3);
    const auto most = [&](const auto& holds) {
      double growth = 1.0;
      while (holds((1.0 + growth * altitude) * up)) growth *= 1.001;
      return growth;
    };
    const double served = most([&](const glm::dvec3& eye) { return grid.serves(eye, 1e-3); });
    const double reached = most([&](const glm::dvec3& eye) { return grid.reaches(eye, 1e-3); });
    EXPECT_GT(served, 1.1) << altitude;
    EXPECT_GT(reached, 1.1 * served) << altitude;
  }
}

}  // namespace
}  // namespace terrella
