// A node of a ground as a picture draws it.
#pragma once

#include "planet/node_patch.hpp"

namespace terrella {

struct DrawnNode {
  int slot;
  unsigned coarser;  // sides and corners (NodePatch) that it shares with a node in the shape of the level above
  bool as_above;     // it has taken on that shape all over: every second of its vertices will do
};

// Which list of triangles (node_triangles) shows it.
inline unsigned list_of(const NodePatch& patch, const DrawnNode& drawn) {
  return drawn.as_above ? patch.list_of_every_second() : drawn.coarser & all_sides;
}

}  // namespace terrella
