// A grid that lies around the place below an eye and reaches as far as that can see (Michelic 2018, section 3): held
// while the eye moves a little, and made anew then. Its patches are split in four as those of the other grids are,
// which takes the place of the paper's tessellation. Lengths in planet radii.
#pragma once

#include "planet/square_grid.hpp"

namespace terrella {

class PersistentGrid : public SquareGrid {
 public:
  // eye: not 0. top: height of the highest terrain, >= 0; above 0.4 not all that rises beyond the horizon is reached.
  PersistentGrid(const glm::dvec3& eye, double top);

  // Whether it still serves an eye: it reaches all that the eye can see, and would not be much smaller if made for it.
  [[nodiscard]] bool serves(const glm::dvec3& eye) const;

  [[nodiscard]] std::span<const GridNode> roots() const override { return {&root_, 1}; }
  [[nodiscard]] double edge(int level) const override;
  [[nodiscard]] double reach() const override { return reach_; }

 protected:
  [[nodiscard]] glm::dvec3 direction_on(int face, double x, double y) const override;
  [[nodiscard]] std::optional<GridNode> beyond_face(const GridNode&, Side) const override { return std::nullopt; }

 private:
  void measure_cells();

  GridNode root_;
  double altitude_, top_;
  glm::dvec3 u_, v_, w_;  // the third towards the eye
  double zs_;             // how far it stands off the centre
  double stretch_ = 0.0;  // rad, at the most, for a place on the square that is 1 further
  double reach_ = 0.0;
};

}  // namespace terrella
