#include "planet/node_choice.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glm/geometric.hpp>

#include "base/check.hpp"

namespace terrella {
namespace {

// Nodes that are soon to be split have their quarters made before.
constexpr double look_ahead = 1.15;

class Choice {
 public:
  Choice(const NodeSight& sight, const NodeEye& eye, const NodeRanges& ranges, NodeCache& cache, NodeChoice& choice)
      : sight_(sight), eye_(eye), ranges_(ranges), cache_(cache), choice_(choice) {}

  // Splits what is to be split of a level's nodes, and draws the others.
  void pass_level() {
    choice_.next.clear();
    for (const int slot : choice_.level) {
      const QuadNode node = cache_.at(slot).node;
      const double distance = distance_of(cache_.at(slot).frame, eye_);
      const double wanted = node.level < ranges_.deepest ? ranges_.split * node_edge(node.level) : 0.0;
      bool splits = distance < wanted;
      if (distance < look_ahead * wanted) splits = has_quarters(node, distance) && splits;
      splits = splits && coarser_around(node) == 0;
      if (splits) {
        add_quarters(node);
      } else {
        cache_.make_leaf(slot);
        choice_.drawn.push_back({slot, 0});
      }
    }
    std::swap(choice_.level, choice_.next);
  }

  void add_visible(const QuadNode& node) {
    const int slot = cache_.find(node);
    CHECK(slot >= 0, node.face, node.level, node.x, node.y);
    cache_.use(slot);
    if (is_seen(cache_.at(slot))) choice_.next.push_back(slot);
  }

  // Which of the nodes around a drawn one are of the level above.
  [[nodiscard]] unsigned coarser_around(const QuadNode& node) const {
    if (node.level == 0) return 0;
    unsigned coarser = 0;
    for (unsigned i = 0; i < sides.size(); ++i) {
      if (lies_in_leaf(across(node, sides.at(i)))) coarser |= 1U << i;
    }
    for (unsigned i = 0; i < 4; ++i) {
      if (const auto next = beyond_corner(node, i); next && lies_in_leaf(*next)) coarser |= 16U << i;
    }
    return coarser;
  }

 private:
  void add_quarters(const QuadNode& node) {
    for (const QuadNode& child : children_of(node)) add_visible(child);
  }

  // Asks for those that are not there.
  bool has_quarters(const QuadNode& node, double distance) {
    bool all = true;
    for (const QuadNode& child : children_of(node)) {
      const int slot = cache_.find(child);
      if (slot >= 0) {
        cache_.use(slot);
        continue;
      }
      all = false;
      choice_.missing.push_back({child, distance});
    }
    return all;
  }

  // Nodes that are beside the picture are never leaves: nobody sees how they meet their neighbours.
  [[nodiscard]] bool lies_in_leaf(const QuadNode& node) const {
    if (node.level == 0) return false;
    const int above = cache_.find(parent_of(node));
    return above >= 0 && cache_.is_leaf(above);
  }

  // The node that has only a corner in common; none at the corners of the cube, where three meet.
  [[nodiscard]] static std::optional<QuadNode> beyond_corner(const QuadNode& node, unsigned corner) {
    const bool right = (corner & 1U) != 0, top = (corner & 2U) != 0;
    const std::uint32_t last = (1U << static_cast<unsigned>(node.level)) - 1U;
    const Side along_x = right ? Side::right : Side::left, along_y = top ? Side::top : Side::bottom;
    const bool leaves_by_x = node.x == (right ? last : 0), leaves_by_y = node.y == (top ? last : 0);
    if (leaves_by_x && leaves_by_y) return std::nullopt;
    // Sides have other names on the next face, so the edge of the cube comes last.
    return leaves_by_x ? across(across(node, along_y), along_x) : across(across(node, along_x), along_y);
  }

  // Radius of the highest of ground and sea over a node.
  [[nodiscard]] double top_of(const NodeFrame& frame) const {
    return std::max(1.0 + frame.heights.highest, sight_.sea);
  }

  [[nodiscard]] bool is_seen(const NodeCache::Entry& entry) const {
    const NodeFrame& frame = entry.frame;
    const double low = 1.0 + frame.heights.lowest, high = top_of(frame);
    // Around the node's ground and the sea over it, from its lowest to its highest: between the corners the sphere
    // bulges by what its arc rises.
    const glm::dvec3 middle = 0.5 * (low + high) * frame.middle;
    const double width = frame.half_width * high;
    const double radius = std::hypot(width, 0.5 * (high - low) + 0.5 * frame.half_width * width);
    const glm::dvec3 from_eye = middle - sight_.eye;
    for (const glm::dvec3& side : sight_.sides) {
      if (glm::dot(side, from_eye) < -radius) return false;
    }
    return !behind_horizon(frame);
  }

  // Hidden by the occluder, however high the ground rises over the node.
  [[nodiscard]] bool behind_horizon(const NodeFrame& frame) const {
    const double r = sight_.occluder, distance = glm::length(sight_.eye);
    if (r <= 0.0 || distance <= r) return false;
    const double top = std::max(top_of(frame) - r, 0.0);
    const double away = f64::angle_between(frame.middle, sight_.eye);
    return away > f64::hidden_angle(r, distance - r, top) + 2.0 * std::asin(std::min(0.5 * frame.half_width, 1.0));
  }

  const NodeSight& sight_;
  const NodeEye& eye_;
  const NodeRanges& ranges_;
  NodeCache& cache_;
  NodeChoice& choice_;
};

}  // namespace

NodeSight node_sight(const Pose& pose, const View& view, const Rows& rows, double occluder) {
  const double w = view.width, top = view.height - rows.end, bottom = view.height - rows.first;
  const std::array<glm::dvec2, 4> corners = {{{0.0, top}, {0.0, bottom}, {w, bottom}, {w, top}}};
  NodeSight sight = {pose.eye, {}, occluder};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 from = ray_through(pose, view, corners.at(i));
    const glm::dvec3 to = ray_through(pose, view, corners.at((i + 1) % 4));
    sight.sides.at(i) = glm::normalize(glm::cross(to, from));
  }
  return sight;
}

std::array<QuadNode, 6> root_nodes() {
  std::array<QuadNode, 6> roots;
  for (int face = 0; face < 6; ++face) roots.at(static_cast<std::size_t>(face)) = {face, 0, 0, 0};
  return roots;
}

double distance_of(const NodeFrame& node, const NodeEye& eye) {
  const double chord = std::max(glm::distance(node.middle, eye.direction) - node.half_width, 0.0);
  return std::hypot(eye.lift, chord);
}

void choose_nodes(const NodeSight& sight, const NodeEye& eye, const NodeRanges& ranges, NodeCache& cache,
                  NodeChoice& choice) {
  choice.drawn.clear();
  choice.missing.clear();
  choice.level.clear();
  choice.next.clear();
  Choice chooser(sight, eye, ranges, cache, choice);
  for (const QuadNode& root : root_nodes()) chooser.add_visible(root);
  std::swap(choice.level, choice.next);
  // Level by level, so that each node knows what its neighbours above have become.
  while (!choice.level.empty()) chooser.pass_level();
  for (DrawnNode& drawn : choice.drawn) drawn.coarser = chooser.coarser_around(cache.at(drawn.slot).node);
  std::sort(choice.missing.begin(), choice.missing.end(), [](const MissingNode& a, const MissingNode& b) {
    return std::tie(a.node.level, a.distance) < std::tie(b.node.level, b.distance);
  });
}

}  // namespace terrella
