#include "native/progress_lines.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace terrella {
namespace {

// What is said of a work that is told of so often and takes so long.
std::vector<std::string> said_of(ProgressLines& lines, const char* what, double takes, int times) {
  std::vector<std::string> said;
  for (int i = 0; i <= times; ++i) {
    const double part = static_cast<double>(i) / times;
    if (const auto line = lines.line(what, part, part * takes)) said.push_back(*line);
  }
  return said;
}

TEST(ProgressLines, SayNothingOfWhatIsSoonDone) {
  ProgressLines lines;
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(said_of(lines, "drawing", 0.9 * ProgressLines::apart, 100).empty());
}

TEST(ProgressLines, TellEveryTenthOfALongWorkOnce) {
  ProgressLines lines;
  const std::vector<std::string> said = said_of(lines, "drawing", 6000.0, 5000);
  ASSERT_EQ(said.size(), 10U);
  EXPECT_EQ(said.front(), "drawing: 10 %");
  EXPECT_EQ(said.back(), "drawing: 100 %");
}

TEST(ProgressLines, LieApartAndEndWithTheWork) {
  ProgressLines lines;
  EXPECT_EQ(said_of(lines, "drawing", 2.6 * ProgressLines::apart, 1000),
            (std::vector<std::string>{"drawing: 38 %", "drawing: 77 %", "drawing: 100 %"}));
  // Of a work of few steps, too.
  EXPECT_EQ(said_of(lines, "drawing", 1.5 * ProgressLines::apart, 2), (std::vector<std::string>{"drawing: 100 %"}));
}

TEST(ProgressLines, BeginAnewWithAnotherWork) {
  ProgressLines lines;
  EXPECT_EQ(lines.line("one", 0.0, 0.0), std::nullopt);
  EXPECT_EQ(lines.line("one", 0.5, 100.0), "one: 50 %");
  EXPECT_EQ(lines.line("two", 0.5, 101.0), std::nullopt);
  EXPECT_EQ(lines.line("two", 0.9, 102.0), std::nullopt);
  EXPECT_EQ(lines.line("two", 0.9, 130.0), "two: 90 %");
}

}  // namespace
}  // namespace terrella
