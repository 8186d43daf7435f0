#include "measure/covering.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace terrella {
namespace {

// Pairs of values that stand in no row.
int missing_pairs(const std::vector<int>& levels, const std::vector<std::vector<int>>& rows) {
  int missing = 0;
  for (std::size_t f = 0; f < levels.size(); ++f) {
    for (std::size_t g = f + 1; g < levels.size(); ++g) {
      for (int a = 0; a < levels[f]; ++a) {
        for (int b = 0; b < levels[g]; ++b) {
          bool met = false;
          for (const std::vector<int>& row : rows) met = met || (row[f] == a && row[g] == b);
          missing += met ? 0 : 1;
        }
      }
    }
  }
  return missing;
}

TEST(CoveringPairs, LetEveryTwoValuesMeet) {
  const std::vector<std::vector<int>> tables = {
      {2, 2}, {3, 3, 3, 3}, {1, 4, 2, 5}, std::vector<int>(20, 2), std::vector<int>(40, 3)};
  for (const std::vector<int>& levels : tables) {
    const auto rows = covering_pairs(levels, 7U);
    EXPECT_EQ(missing_pairs(levels, rows), 0);
    for (const std::vector<int>& row : rows) {
      ASSERT_EQ(row.size(), levels.size());
      for (std::size_t f = 0; f < row.size(); ++f) {
        EXPECT_GE(row[f], 0);
        EXPECT_LT(row[f], levels[f]);
      }
    }
  }
}

TEST(CoveringPairs, LackSomethingWithoutAnyOfTheirFirstRows) {
  const std::vector<int> levels(10, 3);
  auto rows = covering_pairs(levels, 7U);
  rows.erase(rows.begin());
  EXPECT_GT(missing_pairs(levels, rows), 0);  // so that the test above can fail
}

TEST(CoveringPairs, AreFarFewerThanAllCombinations) {
  EXPECT_EQ(covering_pairs(std::vector<int>{4, 5}, 7U).size(), 20U);
  // Measured: 27 rows; at least 9 are needed for the first two factors alone.
  EXPECT_LE(covering_pairs(std::vector<int>(40, 3), 7U).size(), 32U);
}

TEST(CoveringPairs, AreTheSameForTheSameSeed) {
  const std::vector<int> levels(15, 3);
  EXPECT_EQ(covering_pairs(levels, 1U), covering_pairs(levels, 1U));
  EXPECT_NE(covering_pairs(levels, 1U), covering_pairs(levels, 2U));
}

TEST(CoveringPairs, OfNothingAreNothing) {
  EXPECT_TRUE(covering_pairs({}, 1U).empty());
  EXPECT_TRUE(covering_pairs(std::vector<int>{3}, 1U).empty());  // one factor has no pairs
}

}  // namespace
}  // namespace terrella
