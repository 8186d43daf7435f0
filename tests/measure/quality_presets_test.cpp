#include "measure/quality_presets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace terrella {
namespace {

// Settings of so many ms and dB, all on the front.
std::vector<Offer> offers_of(const std::vector<std::pair<double, double>>& points) {
  std::vector<Offer> offers;
  for (const auto& [ms, psnr] : points) offers.push_back({ms, std::pow(10.0, -0.1 * psnr)});
  return offers;
}

std::vector<QualityPreset> chosen_from(const std::vector<Offer>& offers) {
  return quality_presets(offers, front_of(offers));
}

TEST(QualityPresets, AreTheCheapestThatReachTheirTargets) {
  const auto presets = chosen_from(offers_of({{1, 25}, {2, 29}, {3, 33}, {4, 35}, {6, 39}, {8, 41}, {20, 45}}));
  ASSERT_EQ(presets.size(), 4U);
  const std::pair<const char*, std::size_t> expected[] = {{"fast", 1}, {"balanced", 3}, {"high", 5}, {"reference", 6}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(presets[i].name, expected[i].first);
    EXPECT_EQ(presets[i].setting, expected[i].second);
    EXPECT_TRUE(presets[i].reached);
  }
}

TEST(QualityPresets, TellWhichTargetIsNotReached) {
  const auto presets = chosen_from(offers_of({{1, 20}, {2, 29}, {4, 31}, {9, 33}}));
  ASSERT_EQ(presets.size(), 3U);
  EXPECT_EQ(presets[0].name, "fast");
  EXPECT_EQ(presets[0].setting, 1U);
  EXPECT_TRUE(presets[0].reached);
  EXPECT_EQ(presets[1].name, "high");
  EXPECT_EQ(presets[1].setting, 2U);
  EXPECT_FALSE(presets[1].reached);
  EXPECT_TRUE(presets[2].reached);
}

// One that misses its target takes no room from one that reaches its own.
TEST(QualityPresets, PreferThoseThatReachTheirTargets) {
  const auto presets = chosen_from(offers_of({{5, 27}, {10, 29}, {11, 30}, {17, 33}}));
  ASSERT_EQ(presets.size(), 2U);
  EXPECT_EQ(presets[0].name, "fast");
  EXPECT_EQ(presets[0].setting, 1U);
}

TEST(QualityPresets, AreDroppedWhereThereIsNoRoomForThem) {
  const auto one_left = chosen_from(offers_of({{5, 38}, {6, 39}, {9, 42}}));
  ASSERT_EQ(one_left.size(), 2U);
  EXPECT_EQ(one_left[0].name, "balanced");  // "high" would take as long as the reference, "fast" as "balanced"
  EXPECT_EQ(one_left[0].setting, 0U);
  const auto one = chosen_from(offers_of({{5, 38}}));
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].name, "reference");
  EXPECT_TRUE(chosen_from({}).empty());
}

TEST(QualityPresets, AreFarEnoughApart) {
  std::vector<std::pair<double, double>> points;
  for (int i = 0; i < 200; ++i) points.emplace_back(1.0 + 0.1 * i, 15.0 + 0.17 * i);
  const std::vector<Offer> offers = offers_of(points);
  const auto presets = chosen_from(offers);
  ASSERT_GE(presets.size(), 2U);
  for (std::size_t i = 1; i < presets.size(); ++i)
    EXPECT_GE(offers[presets[i].setting].ms, 1.6 * offers[presets[i - 1].setting].ms * (1.0 - 1e-12));
}

}  // namespace
}  // namespace terrella
