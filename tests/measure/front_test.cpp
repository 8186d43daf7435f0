#include "measure/front.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace terrella {
namespace {

// Offers at random, of few different values, so that some are equal.
std::vector<Offer> made_up(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  std::vector<Offer> offers(count);
  for (Offer& offer : offers) {
    offer.ms = 1.0 + static_cast<double>(random() % 40U);
    offer.mean_square = 1e-4 * static_cast<double>(random() % 40U);
  }
  return offers;
}

TEST(Front, HoldsWhatNothingDominatesAndDominatesTheRest) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const std::vector<Offer> offers = made_up(seed, 1 + seed * 3);
    const std::vector<std::size_t> front = front_of(offers);
    ASSERT_FALSE(front.empty());
    for (std::size_t i = 0; i < offers.size(); ++i) {
      const auto beats = [&](std::size_t f) { return dominates(offers[f], offers[i]); };
      const auto equals = [&](std::size_t f) {
        return offers[f].ms == offers[i].ms && offers[f].mean_square == offers[i].mean_square;
      };
      const bool on_it = std::find(front.begin(), front.end(), i) != front.end();
      EXPECT_EQ(std::any_of(front.begin(), front.end(), beats),
                !on_it && std::none_of(front.begin(), front.end(), equals));
    }
    for (std::size_t i = 1; i < front.size(); ++i) {
      EXPECT_LT(offers[front[i - 1]].ms, offers[front[i]].ms);
      EXPECT_GT(offers[front[i - 1]].mean_square, offers[front[i]].mean_square);
    }
  }
}

TEST(Front, OfNothingIsNothing) {
  EXPECT_TRUE(front_of({}).empty());
  EXPECT_TRUE(thinned({}, {}, 1.1).empty());
}

TEST(Front, ThinnedKeepsItsEndsAndStepsThatAreNoticed) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const std::vector<Offer> offers = made_up(seed, 60);
    const std::vector<std::size_t> front = front_of(offers), path = thinned(offers, front, 1.3);
    EXPECT_EQ(path.front(), front.front());
    EXPECT_EQ(path.back(), front.back());
    for (std::size_t i = 1; i < path.size(); ++i) {
      const bool two_ends = path.size() == 2;
      EXPECT_TRUE(two_ends || offers[path[i]].ms >= 1.3 * offers[path[i - 1]].ms * (1.0 - 1e-12));
    }
  }
}

TEST(Front, NearlyHoldsWhatABetterTimeWouldPutOnIt) {
  const std::vector<Offer> offers = {{10.0, 0.1}, {11.0, 0.1}, {13.0, 0.1}, {12.0, 0.05}, {20.0, 0.0499}};
  EXPECT_EQ(nearly_on_front(offers, 0.15, 0.01), (std::vector<std::size_t>{0, 1, 3}));
  EXPECT_EQ(nearly_on_front(offers, 0.15, 0.0), (std::vector<std::size_t>{0, 1, 3, 4}));
}

}  // namespace
}  // namespace terrella
