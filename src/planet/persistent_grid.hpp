// A grid that lies around the place below an eye and reaches as far as that can see (Michelic 2018, section 3): held
// while the eye moves a little, and made anew then. Its patches are split in four as those of the other grids are,
// which takes the place of the paper's tessellation. Lengths in planet radii.
#pragma once

#include "planet/square_grid.hpp"

namespace terrella {

class PersistentGrid : public SquareGrid {
 public:
  // eye: not 0. top: height of the highest ground or sea, >= 0; above 0.2 not all that rises beyond the horizon of a
  // far eye is reached.
  PersistentGrid(const glm::dvec3& eye, double top);

  // Whether it was made for just this.
  [[nodiscard]] bool is_for(const glm::dvec3& eye, double top) const { return eye == eye_ && top == top_; }
  // Whether it reaches all that an eye can see.
  [[nodiscard]] bool reaches(const glm::dvec3& eye, double top) const;
  // Whether it still serves an eye: of what it reaches beyond its own eye's sight half is left, and it would not be
  // much smaller if made anew. The other half is for the time in which the next one is made and takes its place.
  [[nodiscard]] bool serves(const glm::dvec3& eye, double top) const;

  [[nodiscard]] std::span<const GridNode> roots() const override { return {&root_, 1}; }
  [[nodiscard]] double edge(int level) const override;
  [[nodiscard]] double reach() const override { return reach_; }

 protected:
  [[nodiscard]] glm::dvec3 direction_on(int face, double x, double y) const override;
  [[nodiscard]] std::optional<GridNode> beyond_face(const GridNode&, Side) const override { return std::nullopt; }

 private:
  // Angle from the middle to the farthest that an eye can see, rad.
  [[nodiscard]] double farthest_seen(const glm::dvec3& eye, double top) const;
  void measure_cells();

  GridNode root_;
  glm::dvec3 eye_;
  double altitude_, top_;
  glm::dvec3 u_, v_, w_;  // the third towards the eye
  double zs_;             // how far it stands off the centre
  double reached_;        // angle from below the eye to where its rim is nearest, rad
  double served_;         // angle from there to the farthest that an eye may see which it serves, rad
  double stretch_ = 0.0;  // rad, at the most, for a place on the square that is 1 further
  double reach_ = 0.0;
};

}  // namespace terrella
