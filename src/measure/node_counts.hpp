// What a ground of nodes asks of a GPU.
#pragma once

#include <cstdint>

#include "measure/node_picture.hpp"

namespace terrella {

// Drawn in all, whether in the picture or not.
struct NodeCounts {
  int nodes = 0;
  std::int64_t vertices = 0, triangles = 0;              // without skirts
  std::int64_t skirt_vertices = 0, skirt_triangles = 0;  // what skirts add
};

NodeCounts operator+(const NodeCounts& a, const NodeCounts& b);

NodeCounts node_counts(const NodePicture& picture, NodeLayer layer);

// Of the ground's triangles without skirts those that turn to the eye and lie in the picture, and have neither
// sea nor planet nor nearer mountains before them: no method can do without these.
std::int64_t seen_triangles(const NodePicture& picture);

// Of the ground's triangles without skirts those that have the shape of the level above and nothing of their own: a
// quarter as many would show the same.
std::int64_t coarse_triangles(const NodePicture& picture);

}  // namespace terrella
