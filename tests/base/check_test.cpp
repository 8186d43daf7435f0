#include "base/check.hpp"

#include <gtest/gtest.h>

#include "base/result.hpp"

namespace terrella {
namespace {

TEST(CheckDeathTest, NamesPlaceConditionAndValues) {
  const int width = -3;
  EXPECT_DEATH(CHECK(width > 0, "an image of ", width), "check_test.cpp:[0-9]+: CHECK\\(width > 0\\) failed: .* -3");
  EXPECT_DEATH(CHECK(width > 0), "CHECK\\(width > 0\\) failed");
}

TEST(Check, WordsItsMessageOnlyWhereItFails) {
  int worded = 0;
  const auto message = [&] { return ++worded; };
  CHECK(true, message());
  EXPECT_EQ(worded, 0);
}

TEST(Result, HoldsAValueOrASentence) {
  const Result<int> good = 3;
  const Result<int> bad = Failure{"The disk is full."};
  EXPECT_TRUE(good);
  EXPECT_EQ(*good, 3);
  EXPECT_EQ(good.sentence(), "");
  EXPECT_FALSE(bad);
  EXPECT_EQ(bad.sentence(), "The disk is full.");
}

TEST(ResultDeathTest, AValueThatIsNotThereIsAProgrammersError) {
  const Result<int> bad = Failure{"The disk is full."};
  EXPECT_DEATH(*bad, "The disk is full");
}

}  // namespace
}  // namespace terrella
