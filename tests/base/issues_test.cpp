#include "base/issues.hpp"

#include <gtest/gtest.h>

#include <array>

namespace terrella {
namespace {

constexpr std::array<std::string_view, 4> kNames = {"waves.count", "waves.steepness", "water.model", "clouds.height"};

TEST(NearestName, FindsWhatWasMeant) {
  EXPECT_EQ(nearest_name("wavs.count", kNames), "waves.count");           // a letter left out
  EXPECT_EQ(nearest_name("waves.countt", kNames), "waves.count");         // one too many
  EXPECT_EQ(nearest_name("water.modal", kNames), "water.model");          // a wrong one
  EXPECT_EQ(nearest_name("waves.steepenss", kNames), "waves.steepness");  // two swapped
  EXPECT_EQ(nearest_name("clouds.height", kNames), "clouds.height");
}

TEST(NearestName, IsSilentRatherThanSilly) {
  EXPECT_EQ(nearest_name("x", kNames), "");
  EXPECT_EQ(nearest_name("", kNames), "");
  EXPECT_EQ(nearest_name("something.else.entirely", kNames), "");
  EXPECT_EQ(nearest_name(std::string(1'000'000, 'w'), kNames), "");
  const std::array<std::string_view, 1> short_names = {"ab"};
  EXPECT_EQ(nearest_name("xy", short_names), "");
}

TEST(NearestName, PrefersTheNearer) {
  const std::array<std::string_view, 3> names = {"calm", "waves", "wave"};
  EXPECT_EQ(nearest_name("wavees", names), "waves");
}

TEST(Issues, ListsTheFirstAndCountsTheRest) {
  Issues issues;
  EXPECT_TRUE(issues.empty());
  for (std::size_t i = 0; i < Issues::kMostListed; ++i) issues.add("a.b", "is wrong.");
  EXPECT_EQ(issues.sentences().size(), Issues::kMostListed);
  EXPECT_EQ(issues.sentences()[0], "a.b: is wrong.");
  issues.add("", "More.");
  issues.add_unlisted();
  EXPECT_EQ(issues.count(), Issues::kMostListed + 2);
  EXPECT_EQ(issues.sentences().size(), Issues::kMostListed + 1);
  EXPECT_EQ(issues.sentences().back(), "and 2 more.");
}

TEST(Issues, AddUpToTheirSum) {
  Issues one, other;
  for (int i = 0; i < 15; ++i) one.add("", "One.");
  for (int i = 0; i < 100; ++i) other.add("", "Other.");
  one.add(other);
  EXPECT_EQ(one.count(), 115u);
  EXPECT_EQ(one.sentences().back(), "and 95 more.");
}

TEST(Issue, SpeaksOfTheWholeInputWithoutAPath) {
  EXPECT_EQ((Issue{"", "The text is empty."}).text(), "The text is empty.");
}

}  // namespace
}  // namespace terrella
