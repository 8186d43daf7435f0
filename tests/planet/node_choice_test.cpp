#include "planet/node_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include <glm/geometric.hpp>

#include "laws/random_places.hpp"
#include "planet/terrain.hpp"
#include "sanitized.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

using test::Places;

using Key = std::tuple<int, int, std::uint32_t, std::uint32_t>;
Key key_of(const QuadNode& node) { return {node.face, node.level, node.x, node.y}; }

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
  // bare: without vertices, whose places a choice does not ask for; their ground may lie anywhere.
  Nodes(const Scene& scene, const NodeRanges& ranges, bool bare = false)
      : ranges_(ranges), bare_(bare), terrain_(exact_terrain_of(scene)) {
    for (const QuadNode& root : root_nodes()) make(root);
  }

  // Until nothing is missing, or with so many turns only part of what is.
  void choose(const Scene& scene, bool all_around, int turns = 100, Places* some = nullptr) {
    View view;
    view.width = 1920;
    view.height = 1080;
    pose_ = pose_of(scene, view);
    eye_ = eye_over(terrain_, pose_);
    NodeSight sight = node_sight(pose_, view, {0, view.height}, 1.0);
    if (all_around) sight = {pose_.eye, {}, 0.0};
    for (int turn = 0; turn < turns; ++turn) {
      cache_.begin_frame();
      choose_nodes(sight, eye_, ranges_, cache_, choice_);
      if (choice_.missing.empty()) return;
      for (const auto& [node, distance] : choice_.missing) {
        if (some == nullptr || some->between(0.0, 1.0) < 0.7) make(node);
      }
    }
    cache_.begin_frame();
    choose_nodes(sight, eye_, ranges_, cache_, choice_);
  }

  void make(const QuadNode& node) {
    const NodeFrame frame = bare_ ? bare_frame(node) : make_node(node, ranges_.cells, terrain_, scratch_);
    ASSERT_TRUE(cache_.insert(node, frame));
  }

  [[nodiscard]] NodeFrame bare_frame(const QuadNode& node) const {
    NodeFrame frame;
    frame.middle = middle_of(node);
    for (int k = 0; k < 4; ++k) {
      frame.half_width =
          std::max(frame.half_width, glm::distance(vertex_direction(node, k % 2, k / 2, 1), frame.middle));
    }
    const double height = f64::terrain_height_at(frame.middle, terrain_, 0.0).value;
    frame.heights = {height - 0.1 * frame.half_width, height + 0.1 * frame.half_width};
    return frame;
  }

  [[nodiscard]] const std::vector<DrawnNode>& drawn() const { return choice_.drawn; }
  [[nodiscard]] const QuadNode& node(const DrawnNode& drawn) const { return cache_.at(drawn.slot).node; }
  [[nodiscard]] const NodeFrame& frame(const DrawnNode& drawn) const { return cache_.at(drawn.slot).frame; }
  [[nodiscard]] const NodeChoice& choice() const { return choice_; }
  [[nodiscard]] const Pose& pose() const { return pose_; }
  [[nodiscard]] const NodeEye& eye() const { return eye_; }
  [[nodiscard]] const f64::Terrain& terrain() const { return terrain_; }
  [[nodiscard]] const NodeRanges& ranges() const { return ranges_; }

 private:
  NodeRanges ranges_;
  bool bare_;
  f64::Terrain terrain_;
  NodeCache cache_{bare_ ? 4000 : 20000};
  NodeChoice choice_;
  NodeVertices scratch_;
  Pose pose_{};
  NodeEye eye_;
};

// Whether every side of every node is flagged as what lies there asks for. Returns how many sides were looked at.
int check_sides(const Nodes& nodes) {
  std::set<Key> drawn;
  for (const DrawnNode& each : nodes.drawn()) drawn.insert(key_of(nodes.node(each)));
  int looked_at = 0;
  for (const DrawnNode& each : nodes.drawn()) {
    const QuadNode& node = nodes.node(each);
    for (unsigned i = 0; i < sides.size(); ++i) {
      const QuadNode next = across(node, sides.at(i));
      const bool coarser = next.level > 0 && drawn.contains(key_of(parent_of(next)));
      EXPECT_EQ((each.coarser >> i & 1U) != 0, coarser);
      // Two levels up there is none: such edges would not meet.
      EXPECT_FALSE(next.level > 1 && drawn.contains(key_of(parent_of(parent_of(next)))));
      ++looked_at;
    }
  }
  return looked_at;
}

TEST(NodeChoice, LeavesNoEdgeWithoutItsOtherSideInTenThousandCameras) {
  Places places(1);
  Scene scene = planet();
  Nodes nodes(scene, {least_split, deepest_level, 8}, true);
  int looked_at = 0;
  for (int n = 0; n < (test::sanitized ? 500 : 10000); ++n) {
    // A cache that has come along a way, and one that starts anew.
    if (n % 50 == 0) nodes = Nodes(scene, {places.between(least_split, 3.5), deepest_level, 8}, true);
    place_at_random(scene, places);
    nodes.choose(scene, false);
    looked_at += check_sides(nodes);
    if (HasFailure()) FAIL() << n;
  }
  EXPECT_GT(looked_at, test::sanitized ? 50'000 : 1'000'000);
}

// As the vertex shader places it; the rim is where nodes meet.
struct Rim {
  const Nodes& nodes;
  const DrawnNode& drawn;
  NodeVertices vertices;

  [[nodiscard]] glm::dvec3 at(int i, int j) const {
    const int cells = nodes.ranges().cells;
    const NodeFrame& frame = nodes.frame(drawn);
    const auto n = static_cast<std::size_t>(j * (cells + 1) + i);
    const glm::dvec3 direction = vertex_direction(nodes.node(drawn), i, j, cells);
    const double away = std::hypot(nodes.eye().lift, glm::distance(direction, nodes.eye().direction)) /
                        node_edge(nodes.node(drawn).level);
    const double begin = nodes.ranges().morph_begin(), end = nodes.ranges().morph_end();
    double part = std::clamp((away - begin) / (end - begin), 0.0, 1.0);
    const bool on[] = {i == 0, i == cells, j == 0, j == cells};
    for (unsigned side = 0; side < 4; ++side) {
      if (on[side] && (drawn.coarser >> side & 1U) != 0) part = 1.0;
    }
    for (unsigned corner = 0; corner < 4; ++corner) {
      if (on[(corner & 1U) != 0 ? 1 : 0] && on[(corner & 2U) != 0 ? 3 : 2] && (drawn.coarser >> (4 + corner) & 1U) != 0)
        part = 1.0;
    }
    return (1.0 + frame.base) * frame.middle +
           glm::dvec3(glm::dvec4(vertices.place[n]) + part * glm::dvec4(vertices.coarser[n]));
  }
};

struct Less {
  bool operator()(const glm::dvec3& a, const glm::dvec3& b) const {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }
};

// All around: every vertex that nodes share lies at one place, and every edge of a rim has its other side.
void check_surface(const Nodes& nodes) {
  const int cells = nodes.ranges().cells;
  std::map<glm::dvec3, glm::dvec3, Less> places;
  std::map<std::pair<glm::dvec3, glm::dvec3>, int, decltype([](const auto& a, const auto& b) {
             return Less()(a.first, b.first) || (a.first == b.first && Less()(a.second, b.second));
           })>
      edges;
  for (const DrawnNode& drawn : nodes.drawn()) {
    Rim rim{nodes, drawn, {}};
    const QuadNode& node = nodes.node(drawn);
    make_node(node, cells, nodes.terrain(), rim.vertices);
    for (unsigned side = 0; side < 4; ++side) {
      const int step = (drawn.coarser >> side & 1U) != 0 ? 2 : 1;
      const auto vertex = [&](int k) -> std::pair<int, int> {
        if (side < 2) return {side == 0 ? 0 : cells, k};
        return {k, side == 2 ? 0 : cells};
      };
      for (int k = 0; k <= cells; k += step) {
        const auto [i, j] = vertex(k);
        const glm::dvec3 direction = vertex_direction(node, i, j, cells), place = rim.at(i, j);
        const auto [found, is_new] = places.try_emplace(direction, place);
        if (!is_new) {
          // Less than a hundredth of a pixel of a thousandth of a radian.
          ASSERT_LT(glm::distance(found->second, place), 1e-5 * node_edge(node.level))
              << node.level << " " << drawn.coarser << " " << i << " " << j;
        }
        if (k == 0) continue;
        const auto [before_i, before_j] = vertex(k - step);
        const glm::dvec3 before = vertex_direction(node, before_i, before_j, cells);
        ++edges[Less()(before, direction) ? std::pair(before, direction) : std::pair(direction, before)];
      }
    }
  }
  for (const auto& [edge, count] : edges) ASSERT_EQ(count, 2);
}

TEST(NodeChoice, MakesOneSurfaceOfAllNodes) {
  Places places(2);
  Scene scene = planet(2e-2);
  for (int n = 0; n < 25; ++n) {
    Nodes nodes(scene, {places.between(least_split, 3.0), deepest_level, n % 2 == 0 ? 8 : 14});
    place_at_random(scene, places);
    nodes.choose(scene, true);
    EXPECT_TRUE(nodes.choice().missing.empty());
    check_surface(nodes);
    if (HasFailure()) FAIL() << n;
  }
}

TEST(NodeChoice, MakesOneSurfaceWhileSomeAreStillMissing) {
  Places places(3);
  Scene scene = planet(2e-2);
  int missing = 0;
  for (int n = 0; n < 40; ++n) {
    Nodes nodes(scene, {least_split, deepest_level, 8});
    place_at_random(scene, places);
    nodes.choose(scene, true, 1 + n % 12, &places);
    missing += nodes.choice().missing.empty() ? 0 : 1;
    check_surface(nodes);
    if (HasFailure()) FAIL() << n;
  }
  EXPECT_GT(missing, 10);
}

TEST(NodeChoice, DropsNothingThatCanBeSeen) {
  Places places(4);
  Scene scene = planet(5e-3);
  scene.terrain.octaves = 12;
  int seen = 0;
  for (int n = 0; n < 30; ++n) {
    Nodes nodes(scene, {least_split, 12, 8});
    place_at_random(scene, places);
    nodes.choose(scene, false);
    std::set<Key> drawn;
    for (const DrawnNode& each : nodes.drawn()) drawn.insert(key_of(nodes.node(each)));
    const glm::dvec3 eye = nodes.pose().eye;
    View view;
    view.width = 1920;
    view.height = 1080;
    const NodeSight sight = node_sight(nodes.pose(), view, {0, view.height}, 1.0);
    for (int k = 0; k < 4000; ++k) {
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
      bool covered = false;
      for (int level = 0; level <= 12 && !covered; ++level) covered = drawn.contains(key_of(node_at(direction, level)));
      ASSERT_TRUE(covered) << n;
    }
  }
  EXPECT_GT(seen, 1000);
}

// What is fine enough is told by distance: no node that is drawn whole is nearer than it may be.
TEST(NodeChoice, SplitsWhatIsNear) {
  Places places(5);
  Scene scene = planet();
  for (int n = 0; n < 50; ++n) {
    Nodes nodes(scene, {2.0, deepest_level, 8});
    place_at_random(scene, places);
    nodes.choose(scene, false);
    for (const DrawnNode& each : nodes.drawn()) {
      const int level = nodes.node(each).level;
      EXPECT_TRUE(level == deepest_level || distance_of(nodes.frame(each), nodes.eye()) >= 2.0 * node_edge(level));
    }
  }
}

TEST(NodeCache, GivesTheSlotOfWhatWasNotUsedForLongest) {
  NodeCache cache(3);
  const auto node = [](std::uint32_t x) { return QuadNode{0, 4, x, 0}; };
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
