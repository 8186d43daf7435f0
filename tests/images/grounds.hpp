// The ways of drawing the ground of a planet of real size, for tests that hold for each.
#pragma once

#include <array>
#include <ostream>

namespace terrella::test {

struct GroundOfNodes {
  int model;  // of terrain.model
  const char* name;
};

inline void PrintTo(const GroundOfNodes& ground, std::ostream* out) { *out << ground.name; }

inline constexpr std::array<GroundOfNodes, 3> grounds_of_nodes = {
    {{3, "persistent_grid"}, {4, "triangle_lod"}, {5, "quadtree"}}};

}  // namespace terrella::test
