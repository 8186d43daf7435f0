// The budget on machines that are made up: a clock, and frames that cost what a path says.
#include "app/quality_budget.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace terrella {
namespace {

const std::vector<double> costs = {1.0, 1.2, 1.5, 2.0, 2.6, 3.4, 4.5, 6.0, 8.0, 11.0, 15.0};

struct Machine {
  double first_step_ms = 4.0;  // of a frame at the first step
  double display_ms = 0.0;     // frames take whole multiples of it; 0: as long as they take
  double noise = 0.05;         // by which frames differ, as a part of their time
  double other_ms = 0.0;       // of work that no step changes
};

class Simulation {
 public:
  Simulation(const Machine& machine, double target) : machine_(machine), target_(target) {}

  void run(double seconds) {
    for (const double end = now_ + seconds; now_ < end;) {
      const int step = budget_.step();
      const double ms = frame_ms(step);
      now_ += 0.001 * ms;
      budget_.note(now_, ms, target_);
      last_ms_ = ms;
      if (budget_.step() < step) falls_.push_back(now_);
    }
  }

  void become(const Machine& machine) { machine_ = machine; }

  [[nodiscard]] int step() const { return budget_.step(); }
  [[nodiscard]] double mean_ms() const { return machine_.other_ms + machine_.first_step_ms * cost(step()); }
  [[nodiscard]] double frame_now() const { return last_ms_; }
  // How often a step was given up since.
  [[nodiscard]] int falls_since(double time) const {
    return static_cast<int>(std::count_if(falls_.begin(), falls_.end(), [&](double t) { return t > time; }));
  }

 private:
  [[nodiscard]] static double cost(int step) { return costs.at(static_cast<std::size_t>(step)); }
  double frame_ms(int step) {
    std::normal_distribution<double> noise(1.0, machine_.noise);
    const double work = std::max(0.2, noise(dice_)) * (machine_.other_ms + machine_.first_step_ms * cost(step));
    if (machine_.display_ms == 0.0) return work;
    return machine_.display_ms * std::ceil(work / machine_.display_ms);
  }

  Machine machine_;
  double target_;
  QualityBudget budget_{costs, 5};
  std::mt19937 dice_{7};
  double now_ = 0.0, last_ms_ = 0.0;
  std::vector<double> falls_;  // s
};

TEST(QualityBudget, ReachesTheBudgetWithinASecond) {
  for (const double first_step_ms : {0.2, 0.7, 2.0, 4.0, 8.0, 14.0}) {
    Simulation simulation({first_step_ms}, 16.0);
    simulation.run(1.0);
    EXPECT_LE(simulation.mean_ms(), 1.1 * 16.0) << first_step_ms;
  }
}

TEST(QualityBudget, SpendsWhatItHas) {
  for (const double first_step_ms : {0.2, 0.7, 2.0, 4.0, 8.0}) {
    Simulation simulation({first_step_ms}, 16.0);
    simulation.run(20.0);
    const auto next = static_cast<std::size_t>(simulation.step() + 1);
    const bool next_fits_well = next < costs.size() && first_step_ms * costs[next] <= 0.8 * 16.0;
    EXPECT_FALSE(next_fits_well) << first_step_ms;
  }
}

// Of what it may try, most does not fit: each time it waits longer.
TEST(QualityBudget, DoesNotSwing) {
  for (double first_step_ms = 0.5; first_step_ms < 20.0; first_step_ms *= 1.07) {
    for (const double display_ms : {0.0, 16.7}) {
      Simulation simulation({first_step_ms, display_ms}, 20.0);
      simulation.run(60.0);
      EXPECT_LE(simulation.falls_since(1.0), 3) << first_step_ms << ' ' << display_ms;
      simulation.run(240.0);
      EXPECT_LE(simulation.falls_since(60.0), 3) << first_step_ms << ' ' << display_ms;
    }
  }
}

TEST(QualityBudget, SurvivesAMachineTenTimesSlower) {
  Simulation simulation({1.5}, 16.0);
  simulation.run(10.0);
  const int before = simulation.step();
  simulation.become({15.0});
  simulation.run(1.0);
  EXPECT_LT(simulation.step(), before);
  EXPECT_LE(simulation.mean_ms(), 1.1 * 16.0);
  simulation.run(60.0);
  EXPECT_LE(simulation.mean_ms(), 1.1 * 16.0);
  simulation.become({1.5});
  simulation.run(60.0);
  EXPECT_GE(simulation.step(), before - 1);
}

TEST(QualityBudget, StaysAtTheFirstStepWhereNoneFits) {
  Simulation simulation({400.0}, 16.0);
  simulation.run(2.0);
  EXPECT_EQ(simulation.step(), 0);
  simulation.run(60.0);
  EXPECT_EQ(simulation.step(), 0);
}

// A display of 60 pictures a second makes every frame last 16.7 ms, whatever is drawn.
TEST(QualityBudget, FindsWhatTheDisplayHides) {
  Simulation simulation({0.5, 16.7}, 17.0);
  simulation.run(60.0);
  EXPECT_GE(0.5 * costs.at(static_cast<std::size_t>(simulation.step())), 5.0);
  EXPECT_LE(simulation.frame_now(), 17.0);
}

TEST(QualityBudget, GivesNothingUpForATimeThatNoStepReaches) {
  Simulation display({1.0, 16.7}, 8.0);
  display.run(60.0);
  EXPECT_GE(display.step(), 5);
  Machine busy{0.01};
  busy.other_ms = 30.0;
  Simulation beside(busy, 16.0);
  beside.run(60.0);
  EXPECT_GE(beside.step(), 5);
}

// Notes one frame after the other: usual ones and, at the end of each period, a late one. Times in ms.
class Frames {
 public:
  void note(int count, double usual, int period, double late, double target) {
    for (int i = 0; i < count; ++i) {
      const double ms = i % period == period - 1 ? late : usual;
      budget.note(now_ += 0.001 * ms, ms, target);
    }
  }
  void note(int count, double ms, double target) { note(count, ms, 1, ms, target); }

  QualityBudget budget{costs, 5};

 private:
  double now_ = 0.0;  // s
};

TEST(QualityBudget, NoticesAtOnceThatFramesHaveBecomeSlower) {
  Frames frames;
  frames.note(80, 15.0, 16.0);
  frames.note(3, 150.0, 16.0);
  EXPECT_EQ(frames.budget.step(), 0);
}

// A browser takes some frames at once and then waits until they are drawn.
TEST(QualityBudget, SeesThroughBursts) {
  Frames frames;
  frames.note(10, 16.0, 4, 250.0, 40.0);
  EXPECT_LT(frames.budget.step(), 5);
}

TEST(QualityBudget, ALateFrameIsNoSlowMachine) {
  Frames frames;
  for (int period = 0; period < 20; ++period) {
    for (int late = 0; late < 20; ++late) {
      frames.note(1, late == 9 ? 60.0 : 15.0, 16.0);
      ASSERT_GE(frames.budget.step(), 5) << period << ' ' << late;
    }
  }
}

TEST(QualityBudget, ForgetsFramesBeforeAnInterruption) {
  QualityBudget budget(costs, 5);
  for (int i = 1; i < 4; ++i) budget.note(0.02 * i, 20.0, 16.0);
  budget.interrupt();
  budget.note(0.08, 20.0, 16.0);
  EXPECT_EQ(budget.step(), 5);
}

}  // namespace
}  // namespace terrella
