#include "passes/ground_persistent_grid.hpp"

#include "planet/pose.hpp"

namespace terrella {

void GroundPersistentGrid::hold(const Frame& frame) {
  const glm::dvec3& eye = frame.pose.eye;
  const double top = relief_top(frame.scene) - 1.0;
  const auto make_grid = [&] { return std::make_shared<const PersistentGrid>(eye, top); };
  // What a complete picture shows does not depend on what was drawn before.
  const bool at_once = frame.effort == Effort::complete;
  if (!shown_.grid || (at_once && !shown_.grid->is_for(eye, top))) shown_.grid = make_grid();
  if (at_once || shown_.grid->serves(eye, top)) return next_.grid.reset();
  // One that no longer serves before it is whole is shown as it is, or a fast eye would never see any but the first.
  if (next_.grid && !next_.grid->serves(eye, top)) show_next();
  if (shown_.grid->serves(eye, top)) return;
  if (!next_.grid) next_.grid = make_grid();
  // Coarse ground is better than none.
  if (!shown_.grid->reaches(eye, top)) show_next();
}

void GroundPersistentGrid::show_next() {
  std::swap(shown_, next_);
  next_.grid.reset();
}

void GroundPersistentGrid::update(const Frame& frame) {
  hold(frame);
  const auto time_for_shown = next_.grid ? NodeMeshes::Making::none : NodeMeshes::Making::in_time;
  shown_.nodes->update(frame, shown_.grid, time_for_shown);
  if (!next_.grid) return;
  next_.nodes->update(frame, next_.grid, NodeMeshes::Making::in_time);
  if (next_.nodes->settled()) show_next();
}

std::int64_t GroundPersistentGrid::noise_evaluations() const {
  return shown_.nodes->noise_evaluations() + (next_.grid ? next_.nodes->noise_evaluations() : 0);
}

}  // namespace terrella
