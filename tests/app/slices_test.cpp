// What is decided on machines that are made up: what each strip of a picture costs there is known here alone.
#include "app/slices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <random>
#include <vector>

namespace terrella {
namespace {

class Machine {
 public:
  // cost: of a strip, ms; screen: from one picture to the next at the least, ms.
  explicit Machine(std::function<double(int)> cost, double screen = 16.7) : cost_(std::move(cost)), screen_(screen) {}

  // Returns what the bands of the picture cost.
  std::vector<double> draw_picture() {
    std::vector<double> bands;
    for (int i = 0; i < slices.count(); ++i) {
      double ms = overhead;
      for (int s = slices.band(i).first; s < slices.band(i).end; ++s) ms += cost_(s);
      bands.push_back(ms);
      if (slices.count() == 1) slices.whole_came_after(std::max(ms, screen_));
      if (!slices.wants_time_of(i)) continue;
      slices.took(i, ms * std::uniform_real_distribution(1.0 - noise, 1.0 + noise)(chance_));
      ++timed;
    }
    slices.decide();
    return bands;
  }
  void draw(int pictures) {
    for (int i = 0; i < pictures; ++i) {
      const int before = slices.count();
      draw_picture();
      changes += slices.count() != before ? 1 : 0;
    }
  }

  Slices slices;
  double overhead = 2.0, noise = 0.0;  // ms a band; part of a time
  int timed = 0, changes = 0;

 private:
  std::function<double(int)> cost_;
  double screen_;
  std::mt19937 chance_{7};
};

// A planet in the middle of a sky.
double planet(int strip) { return strip < 8 || strip >= 40 ? 0.5 : 5.0; }

TEST(Slices, QuickPicturesAreDrawnWholeAndNeverTimed) {
  Machine machine([](int) { return 0.2; });
  machine.draw(500);
  EXPECT_EQ(machine.slices.count(), 1);
  EXPECT_EQ(machine.timed, 0);
}

TEST(Slices, ASlowScreenIsNoSlowMachine) {
  Machine machine([](int) { return 0.1; }, 33.3);
  machine.draw(1000);
  EXPECT_EQ(machine.slices.count(), 1);
  EXPECT_EQ(machine.changes, 0);
  EXPECT_LE(machine.timed, 11);
}

TEST(Slices, SlowPicturesComeInBandsThatCoverThemAndCostTheSame) {
  Machine machine(planet);
  machine.draw(30);
  ASSERT_EQ(machine.slices.count(), Slices::most);
  int end = 0;
  for (int i = 0; i < Slices::most; ++i) {
    EXPECT_EQ(machine.slices.band(i).first, end);
    EXPECT_GT(machine.slices.band(i).end, end);
    end = machine.slices.band(i).end;
  }
  EXPECT_EQ(end, Slices::strips);
  const std::vector<double> bands = machine.draw_picture();
  EXPECT_LT(*std::max_element(bands.begin(), bands.end()), 1.3 * (172.0 / Slices::most + 2.0));
}

TEST(Slices, ThereAreAsManyAsLastLongEnough) {
  for (const auto& [picture, count] :
       {std::pair{20.0, 1}, {30.0, 2}, {48.0, 3}, {66.0, 4}, {85.0, 5}, {900.0, Slices::most}}) {
    Machine machine([each = picture / Slices::strips](int) { return each; });
    machine.overhead = 0.0;
    machine.draw(50);
    EXPECT_EQ(machine.slices.count(), count) << picture;
  }
}

TEST(Slices, UnsteadyTimesDoNotMakeThemFlap) {
  for (double picture = 20.0; picture < 200.0; picture += 3.0) {
    Machine machine([each = picture / Slices::strips](int) { return each; });
    machine.noise = 0.15;
    machine.draw(60);
    machine.changes = 0;
    machine.draw(600);
    EXPECT_LE(machine.changes, 2) << picture;
  }
}

TEST(Slices, OneBandThatWasHeldUpChangesNothing) {
  Machine machine([](int) { return 1.4; });
  machine.draw(30);
  const int count = machine.slices.count();
  machine.slices.took(0, 500.0);
  machine.slices.decide();
  machine.draw(20);
  EXPECT_EQ(machine.slices.count(), count);
}

TEST(Slices, FollowASceneThatBecomesCheapAndDearAgain) {
  double each = 3.0;
  Machine machine([&](int) { return each; });
  machine.draw(30);
  EXPECT_GE(machine.slices.count(), 6);
  each = 0.2;
  machine.draw(60);
  EXPECT_EQ(machine.slices.count(), 1);
  each = 3.0;
  machine.draw(60);
  EXPECT_GE(machine.slices.count(), 6);
}

}  // namespace
}  // namespace terrella
