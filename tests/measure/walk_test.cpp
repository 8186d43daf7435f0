#include "measure/walk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace terrella {
namespace {

TEST(Walk, GoesFromAllCheapestToAllFinestStepByStep) {
  const std::vector<int> counts = {3, 1, 2, 5, 4};
  int measured = 0;
  const auto levels = walk_up(counts, [&](const Levels& at) {
    ++measured;
    double ms = 1.0, error = 1.0;
    for (std::size_t k = 0; k < at.size(); ++k) {
      ms += at[k] * (1.0 + static_cast<double>(k));
      error *= std::pow(0.5, at[k]);
    }
    return Offer{ms, error};
  });
  EXPECT_EQ(levels.front(), (Levels{0, 0, 0, 0, 0}));
  EXPECT_EQ(levels.back(), (Levels{2, 0, 1, 4, 3}));
  ASSERT_EQ(levels.size(), 11U);
  for (std::size_t i = 1; i < levels.size(); ++i) {
    int raised = 0;
    for (std::size_t k = 0; k < counts.size(); ++k) raised += levels[i][k] - levels[i - 1][k];
    EXPECT_EQ(raised, 1);
  }
  EXPECT_LE(measured, 1 + 10 * 4);
}

TEST(Walk, BuysFirstWhatGivesMostForItsTime) {
  const std::vector<double> costs = {10.0, 1.0, 3.0}, gains = {0.5, 0.5, 0.5};
  const auto levels = walk_up({2, 2, 2}, [&](const Levels& at) {
    Offer offer = {5.0, 1.0};
    for (std::size_t k = 0; k < 3; ++k) {
      offer.ms += at[k] * costs[k];
      offer.mean_square *= at[k] == 1 ? gains[k] : 1.0;
    }
    return offer;
  });
  EXPECT_EQ(levels[1], (Levels{0, 1, 0}));
  EXPECT_EQ(levels[2], (Levels{0, 1, 1}));
}

TEST(Walk, FindsAKnobThatOnlyAnotherOneMakesWorthRaising) {
  // The last knob gives nothing before the first is up, and then most.
  const auto levels = walk_up({2, 9, 9, 9, 2}, [](const Levels& at) {
    double ms = 10.0, error = 1.0;
    for (std::size_t k = 1; k < 4; ++k) ms += at[k], error *= std::pow(0.95, at[k]);
    if (at[0] == 1) error *= 0.5;
    if (at[0] == 1 && at[4] == 1) error *= 0.01;
    return Offer{ms + at[4], error};
  });
  std::size_t found = 0;
  while (levels[found][4] == 0) ++found;
  EXPECT_LT(found, 8U);
}

}  // namespace
}  // namespace terrella
