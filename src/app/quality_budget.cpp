#include "app/quality_budget.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.hpp"

namespace terrella {
namespace {

constexpr double too_long = 1.1;       // times the target: frames are never all alike
constexpr double fits_well = 0.8;      // times the target: costs are those of another scene on another machine
constexpr double aim_of_a_fall = 0.9;  // times the target
constexpr std::size_t frames_to_fall = 4;
constexpr double time_to_fall = 0.15;                                 // s: where frames are slow, fewer must do
constexpr double time_to_rise = 0.4;                                  // s
constexpr double time_to_probe = 1.5;                                 // s
constexpr double shortest_patience = 20.0, longest_patience = 160.0;  // s

// What three of four frames keep to; of two the faster.
double usual(std::vector<double> times) {
  const auto place = static_cast<std::ptrdiff_t>(0.7 * static_cast<double>(times.size() - 1));
  std::nth_element(times.begin(), times.begin() + place, times.end());
  return times[static_cast<std::size_t>(place)];
}

}  // namespace

QualityBudget::QualityBudget(std::vector<double> costs, int first)
    : costs_(std::move(costs)), step_(first), too_dear_(last() + 1), patience_(shortest_patience) {
  CHECK(!costs_.empty() && first >= 0 && first <= last(), "step ", first, " of ", costs_.size());
}

void QualityBudget::note(double now, double ms, double target) {
  if (std::exchange(skip_, false)) return;
  if (times_.empty()) since_ = now - 0.001 * ms;
  times_.push_back(ms);
  const double elapsed = now - since_;
  if (times_.size() < 2 || (times_.size() < frames_to_fall && elapsed < time_to_fall)) return;
  // Single frames are late for reasons of their own.
  const auto latest = std::min(times_.size(), frames_to_fall);
  const double usual_ms = usual({times_.end() - static_cast<std::ptrdiff_t>(latest), times_.end()});
  if (usual_ms < 0.8 * floor_) floor_ = 0.0;
  judge_change(usual_ms);
  const double most = std::max(target, 1.05 * floor_);
  if (usual_ms > too_long * most) return fall(now, usual_ms, most);
  if (elapsed >= time_to_rise) rise(now, usual(times_), most);
  if (elapsed >= 2.0 * time_to_probe) times_.clear();  // what was long ago tells little
}

// Whether the last change changed the time of a frame as it should have.
void QualityBudget::judge_change(double ms) {
  if (!change_) return;
  const double expected = cost(step_) / change_->cost - 1.0, found = ms / change_->ms - 1.0;
  change_.reset();
  if (std::abs(expected) < 0.2) return;  // too little to be told
  waits_ = std::abs(found) < 0.25 * std::abs(expected);
  if (*waits_) floor_ = ms;
}

int QualityBudget::finest_within(double most, double ms) const {
  int step = 0;
  while (step < last() && ms * cost(step + 1) / cost(step_) <= most) ++step;
  return step;
}

void QualityBudget::fall(double now, double ms, double target) {
  if (step_ == 0) return times_.clear();
  if (now > too_dear_until_ + patience_) patience_ = shortest_patience;  // the last time was another story
  too_dear_ = step_;
  too_dear_until_ = now + patience_;
  patience_ = std::min(2.0 * patience_, longest_patience);
  go_to(std::min(finest_within(aim_of_a_fall * target, ms), step_ - 1), ms);
}

void QualityBudget::rise(double now, double ms, double target) {
  if (now >= too_dear_until_) too_dear_ = last() + 1;
  const int open = std::min(too_dear_ - 1, last());
  const int fitting = std::min(finest_within(fits_well * target, ms), open);
  if (fitting > step_) return go_to(fitting, ms);
  const bool may_wait = waits_.value_or(true) || now >= too_dear_until_;
  if (may_wait && step_ < open && ms <= target && now - since_ >= time_to_probe) go_to(step_ + 1, ms);
}

void QualityBudget::go_to(int step, double ms) {
  change_ = Change{ms, cost(step_)};
  step_ = step;
  skip_ = true;
  times_.clear();
}

}  // namespace terrella
