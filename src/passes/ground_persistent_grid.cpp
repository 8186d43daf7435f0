#include "passes/ground_persistent_grid.hpp"

#include "planet/pose.hpp"

namespace terrella {

void GroundPersistentGrid::update(const Frame& frame) {
  const auto make_grid = [&] {
    return std::make_shared<const PersistentGrid>(frame.pose.eye, top_radius(frame.scene) - 1.0);
  };
  const bool at_once = frame.effort == Effort::complete || !shown_.grid;
  const bool serves = shown_.grid && shown_.grid->serves(frame.pose.eye);
  if (at_once) {
    next_.grid.reset();
    if (!serves) shown_.grid = make_grid();
  } else if (!serves && !next_.grid) {
    next_.grid = make_grid();
  }
  shown_.nodes->update(frame, shown_.grid);
  if (!next_.grid) return;
  next_.nodes->update(frame, next_.grid);
  if (!next_.nodes->settled()) return;
  std::swap(shown_, next_);
  next_.grid.reset();
}

std::int64_t GroundPersistentGrid::noise_evaluations() const {
  return shown_.nodes->noise_evaluations() + (next_.grid ? next_.nodes->noise_evaluations() : 0);
}

}  // namespace terrella
