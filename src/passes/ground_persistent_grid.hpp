// The ground as a grid around the place below the eye, held while that moves a little (Michelic 2018, section 3). While
// the next one is made the one before goes on being drawn; then it gives way picture by picture (part_before).
#pragma once

#include "passes/ground_nodes.hpp"
#include "planet/persistent_grid.hpp"

namespace terrella {

class GroundPersistentGrid : public GroundNodes {
 public:
  void update(const Frame& frame) override;
  [[nodiscard]] const NodeMeshes* nodes(GroundShown shown) const override {
    return (shown == GroundShown::now ? shown_ : other_).nodes.get();
  }
  [[nodiscard]] double part_before() const override { return part_before_; }
  [[nodiscard]] bool settled() const override { return !other_.grid && shown_.nodes->settled(); }
  [[nodiscard]] std::int64_t noise_evaluations() const override;

 private:
  struct Held {
    std::shared_ptr<const PersistentGrid> grid;
    std::unique_ptr<NodeMeshes> nodes = std::make_unique<NodeMeshes>();
  };

  // Settles which grids are shown and made.
  void hold(const Frame& frame);
  // The next one is shown; the one before begins to give way.
  void show_next();
  // What is shown is all that there is.
  void forget_other();
  [[nodiscard]] bool fades() const { return part_before_ > 0.0; }

  // The other: while it fades the one before, else the next one while that is made.
  Held shown_, other_;
  double part_before_ = 0.0;
};

}  // namespace terrella
