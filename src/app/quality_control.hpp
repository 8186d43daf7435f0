// Which settings of quality a planet on screen is drawn with: the scene's own, or those that hold quality.target_ms.
#pragma once

#include <optional>

#include "app/quality_budget.hpp"
#include "scene/quality_path.hpp"

namespace terrella {

// While the planet moves it walks along quality_path() so that frames keep to the target. Where it has rested for a
// moment, the finest step is drawn, once.
class QualityControl {
 public:
  // The step that a scene is drawn at; null where quality.target_ms is 0, so that it is drawn as its own settings say.
  [[nodiscard]] const QualityStep* step_for(const Scene& scene) const;
  // The scene with the settings of that step.
  [[nodiscard]] Scene drawn(Scene scene) const;

  // Something has changed, so that the planet must be drawn anew.
  void moved();
  // Nothing has. now: s of a steady clock. Returns whether the planet is to be drawn anew, at its finest.
  bool rested(double now, const Scene& scene);
  // Whether that is still to come.
  [[nodiscard]] bool will_refine(const Scene& scene) const { return holds_time(scene) && !at_rest_; }

  // A frame of the planet took so long, ms, as frames do while it moves. now: as above.
  void note(double now, double ms, const Scene& scene);
  // The next frames tell nothing about those before.
  void interrupt() { budget_.interrupt(); }

 private:
  QualityBudget budget_ = make_budget();
  std::optional<double> rests_since_;  // s
  bool at_rest_ = false;               // drawn at the finest step

  static QualityBudget make_budget();
};

}  // namespace terrella
