// Which nodes of a grid are drawn for an eye (Andrei, section 2): the finer, the nearer, and no two levels side by side
// that are not neighbours. Lengths in planet radii.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "planet/node_cache.hpp"
#include "planet/node_ranges.hpp"

namespace terrella {

// What can be seen of a ground.
struct NodeSight {
  glm::dvec3 eye;
  std::array<glm::dvec3, 4> sides;  // unit, inwards, of the planes through the eye
  double occluder;                  // radius of a sphere that hides what lies behind it
  bool mountains_hide = false;      // whether nodes are left out of which nothing can be seen over nearer ones
  double sea = 0.0;                 // radius up to which a sea lies over lower ground; 0: there is none
  // By how much it is raised: a part of its distance, and never more than that (Needs).
  double sea_lift = 0.0, most_sea_lift = 0.0;

  // Radius of the highest sea over a node.
  [[nodiscard]] double top_of_sea(const NodeOutline& node) const;
};

// rows: of the picture.
NodeSight node_sight(const Pose& pose, const View& view, const Rows& rows, double occluder);

struct DrawnNode {
  int slot;
  unsigned coarser;  // sides and corners (NodePatch) that it shares with a node in the shape of the level above
  bool as_above;     // it has taken on that shape all over: every second of its vertices will do
};

// Which list of triangles (node_triangles) shows it.
inline unsigned list_of(const NodePatch& patch, const DrawnNode& drawn) {
  return drawn.as_above ? patch.list_of_every_second() : drawn.coarser & all_sides;
}

struct MissingNode {
  GridNode node;
  double distance;  // of the node that it is a quarter of
  bool is_ahead;    // not needed yet
};

// How a node looks from the eye: over which azimuths and how high (leave_out_hidden).
struct NodeSilhouette {
  DrawnNode drawn;
  bool is_known = false;
  double nearest = 0.0;            // from below the eye, as a chord, here and below
  double from = 0.0, to = 0.0;     // azimuths of its corners
  double widened = 0.0;            // by how much its sides may reach beyond these
  double top = 0.0, bottom = 0.0;  // tangents of elevations
  double hidden_from = 0.0;        // from here on it hides all that is no higher than its bottom
};

// Room for a frame's work, so that none is allocated again.
struct NodeChoice {
  std::vector<DrawnNode> drawn;
  // What the picture lacks to be as fine as it should be; where it lacks nothing, what it will soon need, nearer or
  // turned aside. The coarsest first, and of a level the nearest.
  std::vector<MissingNode> missing;
  bool lacks = false;

  std::vector<int> level, next;  // slots of nodes of a level while it is looked through
  std::vector<int> around;       // and of those around the picture
  std::vector<NodeSilhouette> silhouettes;
  // Distances and places of silhouettes: of all by their nearest, and of those that can hide by hidden_from.
  std::array<std::vector<std::pair<double, std::size_t>>, 2> orders;
};

// Replaces what was chosen before. The cache must hold the roots of the grid, and have begun the frame.
void choose_nodes(const NodeGrid& grid, const NodeSight& sight, const NodeEye& eye, const NodeRanges& ranges,
                  NodeCache& cache, NodeChoice& choice);

// How far a node is from the eye, as NodeEye counts.
struct NodeDistance {
  double nearest;   // its nearest place
  double to_split;  // what is held against the distance within which it is split: the same, but where its farthest
                    // place would be left further than `widest` beyond that
};

// widest: NodeGrid::reach, as a distance.
NodeDistance distance_of(const NodeOutline& node, const NodeEye& eye, double widest);

}  // namespace terrella
