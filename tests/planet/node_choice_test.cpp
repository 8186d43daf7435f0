#include "planet/node_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include <glm/geometric.hpp>

#include "effort.hpp"
#include "planet/grids.hpp"
#include "planet/terrain.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

using test::Places;

using NodeKey = std::tuple<int, int, std::uint32_t, std::uint32_t>;
NodeKey key_of(const GridNode& node) { return {node.face, node.level, node.x, node.y}; }

// Smooth, so that nodes are made quickly: which of them are chosen depends on distances alone.
Scene planet(double relief = 1e-3) {
  Scene scene;
  scene.planet.radius = 6.36e6;
  scene.terrain.height = relief * scene.planet.radius;
  scene.terrain.octaves = 3;
  scene.water.model = 0;
  scene.clouds.model = 0;
  scene.camera.fov = 60.0;
  return scene;
}

// Anywhere from a hand's breadth over the ground to a thousand radii away, often at poles, edges and corners of the
// cube.
void place_at_random(Scene& scene, Places& places) {
  auto& camera = scene.camera;
  camera.latitude = places.between(-90.0, 90.0);
  camera.longitude = places.between(-180.0, 180.0);
  const double where = places.between(0.0, 1.0);
  if (where < 0.1) camera.latitude = std::copysign(90.0 - std::pow(10.0, places.between(-8.0, 1.0)), camera.latitude);
  if (where > 0.8) camera.longitude = 45.0 + 90.0 * std::round(places.between(-2.0, 1.0));
  if (where > 0.9) camera.latitude = std::copysign(35.26438968, camera.latitude);
  camera.heading = places.between(-180.0, 180.0);
  camera.pitch = places.between(-90.0, 20.0);
  camera.altitude = 0.0;
  const double ground = glm::length(pose_of(scene, {}).eye) - 1.0;
  camera.altitude = (ground + std::pow(10.0, places.between(-7.0, 3.0))) * scene.planet.radius;
}

// A ground and all that it takes to choose of it.
class Nodes {
 public:
  // split: as many edges more than the least. bare: without vertices, whose places a choice does not ask for; their
  // ground may lie anywhere.
  Nodes(const Scene& scene, test::Grid grid, double split, int cells, bool bare = false)
      : kind_(grid), bare_(bare), top_(scene.terrain.height / scene.planet.radius), terrain_(exact_terrain_of(scene)) {
    ranges_.cells = cells;
    more_split_ = split;
    place(test::grid_for(kind_));
  }

  // Until nothing is missing, or with so many turns only part of what is.
  void choose(const Scene& scene, bool all_around, int turns = 100, Places* some = nullptr) {
    View view;
    view.width = 1920;
    view.height = 1080;
    pose_ = pose_of(scene, view);
    eye_ = eye_over(terrain_, pose_);
    const auto* held = dynamic_cast<const PersistentGrid*>(grid_.get());
    if (held != nullptr && !held->serves(pose_.eye, top_)) place(test::grid_for(kind_, pose_.eye, top_));
    NodeSight sight = node_sight(pose_, view, {0, view.height}, 1.0);
    if (all_around) sight = {pose_.eye, {}, 0.0};
    for (int turn = 0; turn < turns; ++turn) {
      cache_.begin_frame();
      choose_nodes(*grid_, sight, eye_, ranges_, cache_, choice_);
      if (!choice_.lacks && turns > 1) return;
      for (const MissingNode& missing : choice_.missing) {
        if (some == nullptr || some->between(0.0, 1.0) < 0.7) make(missing.node);
      }
    }
    cache_.begin_frame();
    choose_nodes(*grid_, sight, eye_, ranges_, cache_, choice_);
  }

  void make(const GridNode& node) {
    const NodeFrame frame = bare_ ? bare_frame(node) : make_node(*grid_, patch_, node, terrain_, scratch_);
    ASSERT_TRUE(cache_.insert(node, frame));
  }

  [[nodiscard]] NodeFrame bare_frame(const GridNode& node) const {
    NodeFrame frame;
    frame.outline = outline_of(*grid_, outline_, node);
    frame.around = grid_->around(node);
    const double height = f64::terrain_height_at(frame.outline.middle, terrain_, 0.0).value;
    frame.heights = {height - 0.1 * frame.outline.half_width, height + 0.1 * frame.outline.half_width};
    return frame;
  }

  [[nodiscard]] const std::vector<DrawnNode>& drawn() const { return choice_.drawn; }
  [[nodiscard]] const GridNode& node(const DrawnNode& drawn) const { return cache_.at(drawn.slot).node; }
  [[nodiscard]] const NodeFrame& frame(const DrawnNode& drawn) const { return cache_.at(drawn.slot).frame; }
  [[nodiscard]] const NodeChoice& choice() const { return choice_; }
  [[nodiscard]] const Pose& pose() const { return pose_; }
  [[nodiscard]] const NodeEye& eye() const { return eye_; }
  [[nodiscard]] const f64::Terrain& terrain() const { return terrain_; }
  [[nodiscard]] const NodeRanges& ranges() const { return ranges_; }
  [[nodiscard]] const NodeGrid& grid() const { return *grid_; }
  [[nodiscard]] const NodePatch& patch() const { return patch_; }
  void stop_at(int level) { ranges_.deepest = level; }

 private:
  void place(std::shared_ptr<const NodeGrid> grid) {
    grid_ = std::move(grid);
    patch_ = grid_->patch(ranges_.cells);
    outline_ = grid_->patch(4);
    ranges_.reach = grid_->reach();
    ranges_.split = least_split(ranges_.reach) + more_split_;
    cache_.clear();
    for (const GridNode& root : grid_->roots()) make(root);
  }

  test::Grid kind_;
  std::shared_ptr<const NodeGrid> grid_;
  NodePatch patch_, outline_;
  NodeRanges ranges_;
  double more_split_ = 0.0;
  bool bare_;
  double top_;
  f64::Terrain terrain_;
  NodeCache cache_{bare_ ? 8000 : 20000};
  NodeChoice choice_;
  NodeVertices scratch_;
  Pose pose_{};
  NodeEye eye_;
};

class NodeChoices : public testing::TestWithParam<test::Grid> {};

// Whether every side and corner of every node is flagged as what lies there asks for. Returns how many nodes around
// were looked at.
int check_sides(const Nodes& nodes) {
  const NodeGrid& grid = nodes.grid();
  std::set<NodeKey> drawn;
  std::set<NodeKey> as_above;
  for (const DrawnNode& each : nodes.drawn()) {
    drawn.insert(key_of(nodes.node(each)));
    if (each.as_above) as_above.insert(key_of(nodes.node(each)));
  }
  const auto is_drawn = [&](const GridNode& node, int up) {
    GridNode above = node;
    for (; up > 0 && above.level > 0; --up) above = grid.parent_of(above);
    return up == 0 && drawn.contains(key_of(above));
  };
  int looked_at = 0;
  for (const DrawnNode& each : nodes.drawn()) {
    unsigned expected = 0;
    for (const NodeBeside& beside : grid.around(nodes.node(each))) {
      // Nor one above that shows every second vertex only.
      EXPECT_FALSE(is_drawn(beside.node, 1) && as_above.contains(key_of(grid.parent_of(beside.node))));
      if (is_drawn(beside.node, 1) || as_above.contains(key_of(beside.node))) expected |= beside.shares;
      // Two levels up there is none: such edges would not meet.
      EXPECT_FALSE(is_drawn(beside.node, 2));
      ++looked_at;
    }
    EXPECT_EQ(each.coarser, expected);
  }
  return looked_at;
}

// Ten thousand in all on the three spheres, or on each.
TEST_P(NodeChoices, LeaveNoEdgeWithoutItsOtherSideInTenThousandCameras) {
  Places places(1);
  Scene scene = planet();
  Nodes nodes(scene, GetParam(), 0.0, 8, true);
  int looked_at = 0;
  const int cameras = test::by_effort(10'000, 3334, 150);
  for (int n = 0; n < cameras; ++n) {
    // A cache that has come along a way, and one that starts anew.
    if (n % 50 == 0) nodes = Nodes(scene, GetParam(), places.between(0.0, 1.75), 8, true);
    place_at_random(scene, places);
    nodes.choose(scene, false);
    looked_at += check_sides(nodes);
    if (HasFailure()) FAIL() << n;
  }
  EXPECT_GT(looked_at, cameras * 100);
}

// As the vertex shader places it; the rim is where nodes meet.
struct Rim {
  const Nodes& nodes;
  const DrawnNode& drawn;
  NodeVertices vertices;
  std::vector<glm::dvec3> directions;

  [[nodiscard]] glm::dvec3 at(std::size_t n) const {
    const NodeFrame& frame = nodes.frame(drawn);
    const double away = std::hypot(nodes.eye().lift, glm::distance(directions[n], nodes.eye().direction)) /
                        nodes.grid().edge(nodes.node(drawn).level);
    const double begin = nodes.ranges().morph_begin(), end = nodes.ranges().morph_end();
    double part = std::clamp((away - begin) / (end - begin), 0.0, 1.0);
    if ((nodes.patch().vertices[n].touches & drawn.coarser) != 0) part = 1.0;
    return (1.0 + frame.base) * frame.outline.middle +
           glm::dvec3(glm::dvec4(vertices.place[n]) + part * glm::dvec4(vertices.coarser[n]));
  }
};

// All around: every vertex that nodes share lies at one place, and every edge of a rim has its other side, but for
// those around the whole.
void check_surface(const Nodes& nodes) {
  const NodePatch& patch = nodes.patch();
  std::map<glm::dvec3, glm::dvec3, test::LessDirection> places;
  std::map<std::pair<glm::dvec3, glm::dvec3>, std::pair<int, bool>, decltype([](const auto& a, const auto& b) {
             return test::LessDirection()(a.first, b.first) ||
                    (a.first == b.first && test::LessDirection()(a.second, b.second));
           })>
      edges;
  for (const DrawnNode& drawn : nodes.drawn()) {
    const GridNode& node = nodes.node(drawn);
    Rim rim{nodes, drawn, {}, test::directions_of(nodes.grid(), patch, node)};
    make_node(nodes.grid(), patch, node, nodes.terrain(), rim.vertices);
    unsigned with_others = 0;
    for (const NodeBeside& beside : nodes.grid().around(node)) with_others |= beside.shares;
    for (std::size_t k = 0; k < patch.rim.size();) {
      const std::size_t n = patch.rim[k];
      const unsigned side =
          patch.vertices[n].touches & patch.vertices[patch.rim[(k + 1) % patch.rim.size()]].touches & all_sides;
      k += drawn.as_above || (side & drawn.coarser) != 0 ? 2 : 1;
      const std::size_t next = patch.rim[k % patch.rim.size()];
      const glm::dvec3 place = rim.at(n), &here = rim.directions[n], &there = rim.directions[next];
      const auto [found, is_new] = places.try_emplace(here, place);
      // Less than a hundredth of a pixel of a thousandth of a radian.
      ASSERT_TRUE(is_new || glm::distance(found->second, place) < 1e-5 * nodes.grid().edge(node.level))
          << node.level << " " << drawn.coarser << " " << n;
      auto& [count, is_rim] =
          edges[test::LessDirection()(here, there) ? std::pair(here, there) : std::pair(there, here)];
      ++count;
      is_rim = (with_others & side) == 0;
    }
  }
  for (const auto& [edge, found] : edges) ASSERT_EQ(found.first, found.second ? 1 : 2);
}

TEST_P(NodeChoices, MakeOneSurfaceOfAllNodes) {
  Places places(2);
  Scene scene = planet(2e-2);
  for (int n = 0; n < (test::sanitized ? 3 : 25); ++n) {
    Nodes nodes(scene, GetParam(), places.between(0.0, 1.25), n % 2 == 0 ? 8 : 14);
    place_at_random(scene, places);
    nodes.choose(scene, true);
    EXPECT_FALSE(nodes.choice().lacks);
    check_surface(nodes);
    if (HasFailure()) FAIL() << n;
  }
}

TEST_P(NodeChoices, MakeOneSurfaceWhileSomeAreStillMissing) {
  Places places(3);
  Scene scene = planet(2e-2);
  int missing = 0;
  for (int n = 0; n < (test::sanitized ? 6 : 40); ++n) {
    Nodes nodes(scene, GetParam(), 0.0, 8);
    place_at_random(scene, places);
    nodes.choose(scene, true, 1 + n % 12, &places);
    missing += nodes.choice().lacks ? 1 : 0;
    check_surface(nodes);
    if (HasFailure()) FAIL() << n;
  }
  EXPECT_GT(missing, test::sanitized ? 1 : 10);
}

// An eye that moves and turns little by little, with time enough to make what is ahead: no picture lacks anything. One
// node that lacks its quarters would make all coarse that is near it.
TEST_P(NodeChoices, AskForWhatComesIntoView) {
  Places places(8);
  Scene scene = planet();
  int followed = 0;
  for (int n = 0; n < (test::sanitized ? 2 : 20); ++n) {
    Nodes nodes(scene, GetParam(), places.between(0.0, 1.25), 8, true);
    place_at_random(scene, places);
    const double turn = places.between(-2.0, 2.0), nearer = places.between(0.97, 1.0);
    const NodeGrid* before = nullptr;
    for (int step = 0; step < 40; ++step) {
      nodes.choose(scene, false, 0);
      // A grid that is held at the eye is made anew now and then.
      if (before == &nodes.grid()) {
        ++followed;
        EXPECT_FALSE(nodes.choice().lacks) << n << ", " << step;
      }
      before = &nodes.grid();
      while (!nodes.choice().missing.empty()) nodes.choose(scene, false, 1);
      const double ground = glm::length(nodes.pose().eye) - nodes.pose().clearance;
      scene.camera.altitude = (ground + nearer * nodes.pose().clearance - 1.0) * scene.planet.radius;
      scene.camera.heading = std::remainder(scene.camera.heading + turn, 360.0);
    }
  }
  EXPECT_GT(followed, test::sanitized ? 20 : 200);
}

// Whether a triangle of directions, counter-clockwise from outside, has another between them.
bool holds(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& direction) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (glm::dot(glm::cross(corners.at(k), corners.at((k + 1) % 3)), direction) < -1e-15) return false;
  }
  return true;
}

TEST_P(NodeChoices, DropNothingThatCanBeSeen) {
  Places places(4);
  Scene scene = planet(5e-3);
  scene.terrain.octaves = 12;
  int seen = 0;
  for (int n = 0; n < (test::sanitized ? 5 : 30); ++n) {
    Nodes nodes(scene, GetParam(), 0.0, 8);
    nodes.stop_at(12);
    place_at_random(scene, places);
    nodes.choose(scene, false);
    std::vector<std::array<glm::dvec3, 3>> triangles;
    for (const DrawnNode& each : nodes.drawn()) {
      const std::vector<glm::dvec3> own = test::directions_of(nodes.grid(), nodes.patch(), nodes.node(each));
      for (std::size_t k = 0; k < nodes.patch().triangles.size(); k += 3) {
        triangles.push_back({own[nodes.patch().triangles[k]], own[nodes.patch().triangles[k + 1]],
                             own[nodes.patch().triangles[k + 2]]});
      }
    }
    const glm::dvec3 eye = nodes.pose().eye;
    View view;
    view.width = 1920;
    view.height = 1080;
    const NodeSight sight = node_sight(nodes.pose(), view, {0, view.height}, 1.0);
    for (int k = 0; k < 400; ++k) {
      // Around the place below the eye, at any scale.
      const double away = std::pow(10.0, places.between(-7.0, 0.5));
      const glm::dvec3 direction = glm::normalize(nodes.eye().direction + away * places.in_cube(1.0));
      const double height = f64::terrain_height_at(direction, nodes.terrain(), 0.0).value;
      const glm::dvec3 from_eye = (1.0 + height) * direction - eye;
      const bool within = std::all_of(sight.sides.begin(), sight.sides.end(),
                                      [&](const glm::dvec3& side) { return glm::dot(side, from_eye) >= 0.0; });
      // Not hidden by the sphere under all ground.
      const double ahead = -glm::dot(eye, from_eye) / glm::dot(from_eye, from_eye);
      const double nearest = glm::length(eye + std::clamp(ahead, 0.0, 1.0) * from_eye);
      if (!within || nearest < 1.0) continue;
      ++seen;
      ASSERT_TRUE(std::any_of(triangles.begin(), triangles.end(), [&](const auto& corners) {
        return holds(corners, direction);
      })) << n;
    }
  }
  EXPECT_GT(seen, test::sanitized ? 50 : 500);
}

TEST_P(NodeChoices, SplitWhatIsNear) {
  Places places(5);
  Scene scene = planet();
  for (int n = 0; n < test::by_effort(50, 50, 10); ++n) {
    Nodes nodes(scene, GetParam(), 0.25, 8);
    place_at_random(scene, places);
    nodes.choose(scene, false);
    for (const DrawnNode& each : nodes.drawn()) {
      const int level = nodes.node(each).level;
      EXPECT_TRUE(level == deepest_level ||
                  distance_of(nodes.frame(each).outline, nodes.eye(), nodes.ranges().reach * nodes.grid().edge(level))
                          .to_split >= nodes.ranges().split * nodes.grid().edge(level));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OnSphere, NodeChoices, test::all_grids, testing::PrintToStringParamName());

TEST(NodeCache, GivesTheSlotOfWhatWasNotUsedForLongest) {
  NodeCache cache(3);
  const auto node = [](std::uint32_t x) { return GridNode{0, 4, x, 0}; };
  for (std::uint32_t x = 0; x < 3; ++x) {
    cache.begin_frame();
    EXPECT_EQ(*cache.insert(node(x), {}), static_cast<int>(x));
  }
  cache.begin_frame();
  cache.use(cache.find(node(0)));
  EXPECT_EQ(*cache.insert(node(7), {}), 1);
  EXPECT_EQ(cache.find(node(1)), -1);
  EXPECT_GE(cache.find(node(0)), 0);
  cache.use(cache.find(node(2)));
  EXPECT_FALSE(cache.has_room());
  EXPECT_FALSE(cache.insert(node(8), {}));
}

}  // namespace
}  // namespace terrella
