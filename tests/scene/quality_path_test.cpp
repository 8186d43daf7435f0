#include "scene/quality_path.hpp"

#include <gtest/gtest.h>

#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

TEST(QualityPath, RisesInCostAndAccuracy) {
  const auto path = quality_path();
  ASSERT_GE(path.size(), 2U);
  EXPECT_EQ(path.front().cost, 1.0);
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_GT(path[i].cost, path[i - 1].cost) << i;
    EXPECT_GT(path[i].psnr, path[i - 1].psnr) << i;
    EXPECT_FALSE(path[i].quality == path[i - 1].quality) << i;
  }
}

// A preset that is hardly cheaper than the next would only be worse.
TEST(QualityPath, PresetsTakeAtMostTheNextOnesTimeBySixteenTenths) {
  const QualityStep* before = nullptr;
  for (const QualityStep& step : quality_path()) {
    if (step.preset.empty()) continue;
    if (before != nullptr) {
      EXPECT_GE(step.cost, 1.6 * before->cost) << step.preset;
    }
    before = &step;
  }
  ASSERT_NE(before, nullptr);
  EXPECT_EQ(before->preset, "reference");
  EXPECT_EQ(before, &quality_path().back());
}

TEST(QualityPath, ChangesNothingOfASceneButItsQuality) {
  Scene scene = find_preset("storm")->scene;
  scene.quality.target_ms = 12.0;
  for (const QualityStep& step : quality_path()) {
    Scene drawn = with_quality(scene, step);
    EXPECT_TRUE(has_quality(drawn, step));
    EXPECT_EQ(drawn.quality.target_ms, 12.0);
    drawn.quality = scene.quality;
    EXPECT_EQ(drawn, scene);
  }
}

TEST(QualityPath, NamesThePresetThatWasMeant) {
  ASSERT_NE(find_quality("fast"), nullptr);
  EXPECT_EQ(find_quality("fast")->preset, "fast");
  EXPECT_EQ(find_quality(""), nullptr);
  const std::string said = no_such_quality("fats").text();
  EXPECT_NE(said.find("\"fats\" is not a preset of quality; allowed are fast, "), std::string::npos) << said;
  EXPECT_TRUE(said.ends_with("; did you mean fast?")) << said;
}

}  // namespace
}  // namespace terrella
