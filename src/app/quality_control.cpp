#include "app/quality_control.hpp"

#include <utility>
#include <vector>

namespace terrella {
namespace {

// After it, a hand is likely to have come to rest as well.
constexpr double time_to_rest = 0.2;  // s

}  // namespace

QualityBudget QualityControl::make_budget() {
  std::vector<double> costs;
  for (const QualityStep& step : quality_path()) costs.push_back(step.cost);
  const int middle = static_cast<int>(costs.size() / 2);
  return {std::move(costs), middle};
}

const QualityStep* QualityControl::step_for(const Scene& scene) const {
  if (!holds_time(scene)) return nullptr;
  return at_rest_ ? &quality_path().back() : &quality_path()[static_cast<std::size_t>(budget_.step())];
}

Scene QualityControl::drawn(Scene scene) const {
  const QualityStep* step = step_for(scene);
  return step == nullptr ? std::move(scene) : with_quality(std::move(scene), *step);
}

void QualityControl::moved() {
  rests_since_.reset();
  at_rest_ = false;
}

bool QualityControl::rested(double now, const Scene& scene) {
  if (!will_refine(scene)) return false;
  if (!rests_since_) rests_since_ = now;
  at_rest_ = now - *rests_since_ >= time_to_rest;
  return at_rest_;
}

void QualityControl::note(double now, double ms, const Scene& scene) {
  if (will_refine(scene)) budget_.note(now, ms, scene.quality.target_ms);
}

}  // namespace terrella
