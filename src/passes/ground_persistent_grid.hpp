// The ground as a grid around the place below the eye, held while that moves a little (Michelic 2018, section 3). While
// the next one is made the one before goes on being drawn.
#pragma once

#include "passes/ground_nodes.hpp"
#include "planet/persistent_grid.hpp"

namespace terrella {

class GroundPersistentGrid : public GroundNodes {
 public:
  void update(const Frame& frame) override;
  [[nodiscard]] const NodeMeshes* nodes() const override { return shown_.nodes.get(); }
  [[nodiscard]] bool settled() const override { return !next_.grid && shown_.nodes->settled(); }
  [[nodiscard]] std::int64_t noise_evaluations() const override;

 private:
  struct Held {
    std::shared_ptr<const PersistentGrid> grid;
    std::unique_ptr<NodeMeshes> nodes = std::make_unique<NodeMeshes>();
  };

  // Settles which grids are shown and made.
  void hold(const Frame& frame);
  void show_next();

  Held shown_, next_;
};

}  // namespace terrella
