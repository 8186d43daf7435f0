#include "passes/ground_persistent_grid.hpp"

#include <algorithm>

#include "planet/pose.hpp"

namespace terrella {
namespace {

// Pictures in which a grid gives way to the next. In one of a hundred pixels they differ by up to 17 of 255: from
// picture to picture by little more than one. A power of two, so that no part is left.
constexpr int pictures_to_fade = 16;

}  // namespace

void GroundPersistentGrid::hold(const Frame& frame) {
  const glm::dvec3& eye = frame.pose.eye;
  const double top = relief_top(frame.scene) - 1.0;
  const auto make_grid = [&] { return std::make_shared<const PersistentGrid>(eye, top); };
  const auto both_reach = [&] { return shown_.grid->reaches(eye, top) && other_.grid->reaches(eye, top); };
  // What a complete picture shows does not depend on what was drawn before.
  const bool at_once = frame.effort == Effort::complete;
  if (!shown_.grid || (at_once && !shown_.grid->is_for(eye, top))) shown_.grid = make_grid();
  if (at_once) return forget_other();
  if (fades()) {
    part_before_ -= 1.0 / pictures_to_fade;
    if (fades() && both_reach()) return;
    forget_other();
  }
  if (shown_.grid->serves(eye, top)) return forget_other();
  // One that no longer serves before it is whole is shown as it is, or a fast eye would never see any but the first.
  if (other_.grid && !other_.grid->serves(eye, top)) {
    show_next();
    if (both_reach()) return;
    forget_other();
  }
  if (!other_.grid) other_.grid = make_grid();
  // Coarse ground is better than none.
  if (!shown_.grid->reaches(eye, top)) {
    show_next();
    forget_other();
  }
}

void GroundPersistentGrid::show_next() {
  std::swap(shown_, other_);
  part_before_ = 1.0;
}

void GroundPersistentGrid::forget_other() {
  other_.grid.reset();
  part_before_ = 0.0;
}

void GroundPersistentGrid::update(const Frame& frame) {
  hold(frame);
  other_.nodes->make_room(*shown_.grid, frame.needs.ground_cells);
  const bool makes_next = other_.grid && !fades();
  const auto time_if = [](bool makes) { return makes ? NodeMeshes::Making::in_time : NodeMeshes::Making::none; };
  shown_.nodes->update(frame, shown_.grid, time_if(!makes_next));
  if (!other_.grid) return;
  other_.nodes->update(frame, other_.grid, time_if(makes_next));
  if (makes_next && other_.nodes->settled()) show_next();
}

std::int64_t GroundPersistentGrid::noise_evaluations() const {
  return shown_.nodes->noise_evaluations() + (other_.grid ? other_.nodes->noise_evaluations() : 0);
}

}  // namespace terrella
