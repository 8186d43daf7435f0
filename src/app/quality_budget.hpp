// Holds the time of a frame by walking along a path of settings, each dearer and more accurate than the one before.
#pragma once

#include <optional>
#include <vector>

namespace terrella {

// Goes down as soon as frames take too long, as far as the path's costs say is needed; up when a step is expected to
// fit well, or when frames seem to wait for the display, whatever the step. What did not fit is left alone for a while
// that doubles each time, so that it does not swing. Where no step changes the time of a frame, none is given up for
// it.
class QualityBudget {
 public:
  // costs: of a frame at each step, rising, in any unit; one or more. first: the step to begin with, from 0.
  QualityBudget(std::vector<double> costs, int first);

  [[nodiscard]] int step() const { return step_; }

  // A frame drawn at step() took ms, > 0. now: s of a steady clock, never falling. target: ms, > 0.
  void note(double now, double ms, double target);

  // What comes next follows on no frame that was noted: there was a rest, or work of another kind.
  void interrupt() { times_.clear(); }

 private:
  // What the last change did.
  struct Change {
    double ms;    // of a frame before it
    double cost;  // of the step before it
  };

  [[nodiscard]] double cost(int step) const { return costs_.at(static_cast<std::size_t>(step)); }
  [[nodiscard]] int last() const { return static_cast<int>(costs_.size()) - 1; }
  // The finest step that a frame is expected to take at most so long at, knowing how long it takes now.
  [[nodiscard]] int finest_within(double most, double ms) const;
  void judge_change(double ms);
  void fall(double now, double ms, double target);
  void rise(double now, double ms, double target);
  void go_to(int step, double ms);

  std::vector<double> costs_;
  int step_;
  bool skip_ = false;          // the frame noted next was drawn before the change
  std::vector<double> times_;  // ms, since the last change or interruption
  double since_ = 0.0;         // s, when the first of them was noted
  std::optional<Change> change_;
  // Whether frames wait for something that no step changes, the display as a rule; nothing while it is not known.
  std::optional<bool> waits_;
  double floor_ = 0.0;           // ms of a frame that waits
  int too_dear_;                 // the first step that did not fit; beyond the last if none
  double pace_too_dear_ = 0.0;   // ms of a frame for its cost, when that was found
  double too_dear_until_ = 0.0;  // s
  double patience_;              // s for which the next one that does not fit is left alone
};

}  // namespace terrella
