#include "base/numbers.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace terrella {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(AllFinite, IsFalseForAnyThatIsNot) {
  std::vector<double> numbers = {0.0, -1e300};
  EXPECT_TRUE(all_finite(numbers));
  for (const double broken : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    numbers[1] = broken;
    EXPECT_FALSE(all_finite(numbers));
  }
  EXPECT_TRUE(all_finite(std::vector<float>{}));
}

TEST(LargestDifference, IsFoundWhereverItIs) {
  std::vector<float> a(8, 0.5F), b = a;
  EXPECT_EQ(largest_difference(a, b), 0.0);
  b[3] = 0.75F;
  EXPECT_EQ(largest_difference(a, b), 0.25);
  b[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(largest_difference(a, b), infinity);
  EXPECT_EQ(largest_difference(a, std::vector<float>(4)), infinity);
}

}  // namespace
}  // namespace terrella
