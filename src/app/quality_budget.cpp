#include "app/quality_budget.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "base/check.hpp"

namespace terrella {
namespace {

constexpr double too_long = 1.1;       // times the target: frames are never all alike
constexpr double fits_well = 0.8;      // times the target: costs are those of another scene on another machine
constexpr double aim_of_a_fall = 0.9;  // times the target
constexpr std::size_t latest_frames = 8;
constexpr double time_to_fall = 0.15;  // s: where frames are slow, fewer must do
constexpr double time_to_rise = 0.4;   // s
constexpr double time_to_probe = 1.5;  // s
constexpr double much_less = 0.4;      // times: less than what one missed picture of the display makes of it
constexpr double shortest_patience = 20.0, longest_patience = 160.0;  // s

double mean_of(std::span<const double> times) {
  return std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
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
  if (times_.size() < 2 || (times_.size() < latest_frames && elapsed < time_to_fall)) return;
  const std::span<const double> latest = std::span(times_).last(std::min(times_.size(), latest_frames));
  const double mean = mean_of(latest);
  if (mean < 0.8 * floor_) floor_ = 0.0;
  judge_change(mean);
  const double held = std::max(target, 1.05 * floor_), most = too_long * held;
  // A browser's frames come in bursts, so that the mean counts; but a single late one has reasons of its own.
  const auto late = std::count_if(latest.begin(), latest.end(), [&](double time) { return time > most; });
  if (mean > most && late >= 2) return fall(now, mean, held);
  if (elapsed >= time_to_rise) rise(now, mean_of(times_), held);
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
  too_dear_ = step_;
  pace_too_dear_ = ms / cost(step_);
  too_dear_until_ = now + patience_;
  patience_ = std::min(2.0 * patience_, longest_patience);
  go_to(std::min(finest_within(aim_of_a_fall * target, ms), step_ - 1), ms);
}

void QualityBudget::rise(double now, double ms, double target) {
  const bool much_faster = ms / cost(step_) < much_less * pace_too_dear_;
  if (much_faster) patience_ = shortest_patience;
  if (much_faster || now >= too_dear_until_) too_dear_ = last() + 1;
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
