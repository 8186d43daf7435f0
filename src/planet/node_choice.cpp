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

// As are those beside the picture, up to such an angle (rad), or behind the horizon of an eye so many times as high:
// one that comes into view undivided would hold back all that is finer around it.
constexpr double look_aside = 0.15, look_over = 1.25;

// Radius of the highest of ground and sea over a node.
double top_of(const NodeSight& sight, const NodeFrame& frame) {
  return std::max(1.0 + frame.heights.highest, sight.top_of_sea(frame.outline));
}

// beyond: so far from them.
bool is_between(const std::array<glm::dvec3, 4>& sides, const glm::dvec3& eye, const NodeSight& sight,
                const NodeFrame& frame, double beyond) {
  const double low = 1.0 + frame.heights.lowest, high = top_of(sight, frame);
  return std::none_of(sides.begin(), sides.end(),
                      [&](const glm::dvec3& side) { return is_outside(frame.outline, low, high, eye, side, beyond); });
}

class Choice {
 public:
  Choice(const NodeGrid& grid, const NodeSight& sight, const NodeEye& eye, const NodeRanges& ranges, NodeCache& cache,
         NodeChoice& choice)
      : grid_(grid), sight_(sight), eye_(eye), ranges_(ranges), cache_(cache), choice_(choice) {}

  // Splits what is to be split of a level's nodes, and draws the others.
  void pass_level() {
    choice_.next.clear();
    for (const int slot : choice_.level) {
      const GridNode node = cache_.at(slot).node;
      const NodeDistance distance = distance_to(cache_.at(slot));
      const double wanted = split_within(node.level);
      const bool should_split = distance.to_split < wanted;
      Quarters quarters;
      bool splits = distance.to_split < look_ahead * wanted &&
                    find_quarters(node, distance.to_split, !should_split, quarters) && should_split;
      splits = splits && !has_coarser_around(slot);
      waits_ = waits_ || (should_split && !splits);
      if (splits) {
        for (const int quarter : quarters) add_visible(quarter);
      } else {
        const bool as_above = node.level > 0 && distance.nearest >= ranges_.morph_end() * grid_.edge(node.level);
        cache_.make_leaf(slot, as_above);
        choice_.drawn.push_back({slot, 0, as_above});
      }
    }
    std::swap(choice_.level, choice_.next);
  }

  // Asks for what the nodes around the picture will be divided into when they are seen.
  void look_around() {
    for (std::size_t n = 0; n < choice_.around.size(); ++n) {
      const NodeCache::Entry& entry = cache_.at(choice_.around[n]);
      const double distance = distance_to(entry).to_split;
      Quarters quarters;
      if (distance >= look_ahead * split_within(entry.node.level)) continue;
      if (!find_quarters(entry.node, distance, true, quarters)) continue;
      for (const int quarter : quarters) {
        if (is_around(cache_.at(quarter))) choice_.around.push_back(quarter);
      }
    }
  }

  void add_root(const GridNode& node) {
    const int slot = cache_.find(node);
    CHECK(slot >= 0, node.face, node.level, node.x, node.y);
    add_visible(slot);
  }

  // Which of the nodes around a drawn one are of the level above, or in its shape.
  [[nodiscard]] unsigned coarse_around(int slot) const {
    unsigned coarse = 0;
    const NodeCache::Entry& entry = cache_.at(slot);
    // None that has a place in common with it is as far as that. To spare: by so much are the rhombi around a corner of
    // the cube wider than a square.
    constexpr double to_spare = 0.75;
    const double begins = (ranges_.morph_end() - to_spare) * grid_.edge(entry.node.level);
    const double farthest = std::hypot(eye_.lift, farthest_from(entry.frame.outline, eye_.direction));
    if (!waits_ && farthest < begins) return coarse;
    for (const NodeBeside& beside : entry.frame.around) {
      if ((coarse & beside.shares) == 0 && (lies_in_leaf(beside.node) || is_as_above(beside.node)))
        coarse |= beside.shares;
    }
    return coarse;
  }

 private:
  using Quarters = std::array<int, 4>;  // slots

  [[nodiscard]] NodeDistance distance_to(const NodeCache::Entry& entry) const {
    return distance_of(entry.frame.outline, eye_, ranges_.reach * grid_.edge(entry.node.level));
  }

  // Nearer than this a node of a level is split; 0: it never is.
  [[nodiscard]] double split_within(int level) const {
    return level < ranges_.deepest ? ranges_.split * grid_.edge(level) : 0.0;
  }

  void add_visible(int slot) {
    cache_.use(slot);
    if (is_seen(cache_.at(slot))) {
      choice_.next.push_back(slot);
    } else if (is_around(cache_.at(slot))) {
      choice_.around.push_back(slot);
    }
  }

  // Whether they are all there; asks for those that are not.
  bool find_quarters(const GridNode& node, double distance, bool is_ahead, Quarters& quarters) {
    bool all = true;
    const std::array<GridNode, 4> children = grid_.children_of(node);
    for (std::size_t n = 0; n < children.size(); ++n) {
      const GridNode& child = children.at(n);
      const int slot = quarters.at(n) = cache_.find(child);
      if (slot < 0) {
        all = false;
        choice_.missing.push_back({child, distance, is_ahead});
      } else if (!is_ahead) {
        cache_.use(slot);  // what is only ahead gives way where there is no room
      }
    }
    return all;
  }

  [[nodiscard]] bool has_coarser_around(int slot) const {
    const NodesAround& around = cache_.at(slot).frame.around;
    return std::any_of(around.begin(), around.end(),
                       [&](const NodeBeside& beside) { return lies_in_leaf(beside.node); });
  }

  [[nodiscard]] bool is_as_above(const GridNode& node) const {
    const int slot = cache_.find(node);
    return slot >= 0 && cache_.is_as_above(slot);
  }

  // Nodes that are beside the picture are never leaves: nobody sees how they meet their neighbours.
  [[nodiscard]] bool lies_in_leaf(const GridNode& node) const {
    if (node.level == 0) return false;
    const int above = cache_.find(grid_.parent_of(node));
    return above >= 0 && cache_.is_leaf(above);
  }

  [[nodiscard]] bool is_seen(const NodeCache::Entry& entry) const {
    const NodeFrame& frame = entry.frame;
    return is_near_enough(frame) &&
           (is_in_picture(sight_, frame, 0.0) || is_in_mirror(sight_, frame, 1.0 + frame.heights.highest)) &&
           !behind_horizon(frame, 1.0);
  }

  [[nodiscard]] bool is_around(const NodeCache::Entry& entry) const {
    return is_in_picture(sight_, entry.frame, look_aside) && !behind_horizon(entry.frame, look_over);
  }

  [[nodiscard]] bool is_near_enough(const NodeFrame& frame) const {
    return std::isinf(sight_.farthest) || nearest_to(frame.outline, eye_.direction) < sight_.farthest;
  }

  // Hidden by the occluder, however high the ground rises over the node, from an eye so many times as high.
  [[nodiscard]] bool behind_horizon(const NodeFrame& frame, double times_as_high) const {
    const double r = sight_.occluder, distance = glm::length(sight_.eye);
    if (r <= 0.0 || distance <= r) return false;
    const double top = std::max(top_of(sight_, frame) - r, 0.0);
    const double away = f64::angle_between(frame.outline.middle, sight_.eye);
    return away > f64::hidden_angle(r, times_as_high * (distance - r), top) +
                      2.0 * std::asin(std::min(0.5 * frame.outline.half_width, 1.0));
  }

  const NodeGrid& grid_;
  const NodeSight& sight_;
  const NodeEye& eye_;
  const NodeRanges& ranges_;
  NodeCache& cache_;
  NodeChoice& choice_;
  bool waits_ = false;  // whether a node is not split that should be
};

}  // namespace

bool is_in_picture(const NodeSight& sight, const NodeFrame& node, double aside) {
  const double distance = glm::distance(sight.eye, node.outline.middle) + node.outline.half_width;
  return is_between(sight.sides, sight.eye, sight, node, sight.sea_swell + aside * distance);
}

bool is_in_mirror(const NodeSight& sight, const NodeFrame& node, double highest) {
  if (!sight.mirror) return false;
  const double pixel = sight.mirror->pixel * nearest_to(node.outline, glm::normalize(sight.eye));
  return highest > sight.sea + pixel && is_between(sight.mirror->sides, sight.mirror->eye, sight, node, 0.0);
}

NodeDistance distance_of(const NodeOutline& node, const NodeEye& eye, double widest) {
  const double nearest = std::hypot(eye.lift, nearest_to(node, eye.direction));
  return {nearest, std::max(nearest, std::hypot(eye.lift, farthest_from(node, eye.direction)) - widest)};
}

void choose_nodes(const NodeGrid& grid, const NodeSight& sight, const NodeEye& eye, const NodeRanges& ranges,
                  NodeCache& cache, NodeChoice& choice) {
  choice.drawn.clear();
  choice.missing.clear();
  choice.level.clear();
  choice.next.clear();
  choice.around.clear();
  Choice chooser(grid, sight, eye, ranges, cache, choice);
  for (const GridNode& root : grid.roots()) chooser.add_root(root);
  std::swap(choice.level, choice.next);
  // Level by level, so that each node knows what its neighbours above have become.
  while (!choice.level.empty()) chooser.pass_level();
  if (sight.mountains_hide) leave_out_hidden(grid, sight, ranges.cells, cache, choice.silhouettes, choice.drawn);
  for (DrawnNode& drawn : choice.drawn) drawn.coarser = chooser.coarse_around(drawn.slot);
  choice.lacks = std::any_of(choice.missing.begin(), choice.missing.end(),
                             [](const MissingNode& missing) { return !missing.is_ahead; });
  if (choice.lacks) {
    std::erase_if(choice.missing, [](const MissingNode& missing) { return missing.is_ahead; });
  } else {
    chooser.look_around();
  }
  std::sort(choice.missing.begin(), choice.missing.end(), [](const MissingNode& a, const MissingNode& b) {
    return std::tie(a.node.level, a.distance) < std::tie(b.node.level, b.distance);
  });
}

}  // namespace terrella
