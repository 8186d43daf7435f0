// A sphere as a cube whose six faces are quadtrees (Andrei, section 2), numbered as OpenGL numbers faces
// (cube_face_direction). The places on a face are spread by tangents, so that nodes of a level differ little in size.
#pragma once

#include "planet/square_grid.hpp"

namespace terrella {

class CubeGrid : public SquareGrid {
 public:
  [[nodiscard]] std::span<const GridNode> roots() const override;
  [[nodiscard]] double edge(int level) const override;
  [[nodiscard]] double reach() const override { return 1.4143; }  // a square's diagonal

  // The node of a level that a direction (not 0) passes through.
  [[nodiscard]] GridNode node_at(const glm::dvec3& direction, int level) const;

 protected:
  [[nodiscard]] glm::dvec3 direction_on(int face, double x, double y) const override;
  [[nodiscard]] std::optional<GridNode> beyond_face(const GridNode& node, Side side) const override;
};

}  // namespace terrella
