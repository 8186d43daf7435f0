#include "hand.hpp"
#include "scene/surprise.hpp"
#include "scene/view_groups.hpp"

namespace terrella {
namespace {

// So often that what may change does so at least once.
constexpr int often = 40;

std::string name(std::string_view text) { return std::string(text); }

TEST_F(PanelTest, TheWholePlanetIsDrawnByChance) {
  EXPECT_TRUE(click("random").scene_changed);
  const Scene first = document.scene;
  EXPECT_NE(first, Scene{});
  EXPECT_EQ(seen_as(first, Scene{}), first);
  click("random");
  EXPECT_NE(document.scene, first);
}

TEST_F(PanelTest, AGroupIsDrawnByChance) {
  bool changed = false;
  for (int i = 0; i < often; ++i) changed = click("clouds/random").scene_changed || changed;
  EXPECT_TRUE(changed);
  document.scene.clouds = Scene{}.clouds;
  EXPECT_EQ(document.scene, Scene{});
}

TEST_F(PanelTest, WhatIsLockedStaysUntilItIsUnlocked) {
  click("air");
  click("air.height/lock");
  click("air.color/lock");
  const auto& air = document.scene.air;
  bool density_changed = false, height_changed = false;
  for (int i = 0; i < often; ++i) {
    click(i % 2 == 0 ? "random" : "air/random");
    density_changed = density_changed || air.density != Scene{}.air.density;
    ASSERT_EQ(air.height, Scene{}.air.height);
    ASSERT_EQ(air.color, Scene{}.air.color);
  }
  click("air.height/lock");
  for (int i = 0; i < often; ++i) {
    click("random");
    height_changed = height_changed || air.height != Scene{}.air.height;
    ASSERT_EQ(air.color, Scene{}.air.color);
  }
  EXPECT_TRUE(density_changed);
  EXPECT_TRUE(height_changed);
}

TEST_F(PanelTest, ALockChangesNoValue) {
  click("air");
  EXPECT_EQ(click("air.height/lock"), PanelWishes{});
  EXPECT_EQ(document, SceneDocument{});
}

TEST_F(PanelTest, HowThePlanetIsLookedAtIsNoMatterOfChance) {
  open_all_groups();
  for (const Group& group : groups()) {
    EXPECT_EQ(count_of(name(group.name) + "/random"), is_of_view(group.name) ? 0 : 1) << group.name;
  }
  for (const Parameter& parameter : parameters()) {
    EXPECT_EQ(count_of(name(parameter.path) + "/lock"), is_for_chance(parameter) ? 1 : 0) << parameter.path;
  }
}

TEST_F(PanelTest, AKeyDrawsByChanceWithTheLocksOfThePanel) {
  click("air");
  click("air.density/lock");
  bool color_changed = false;
  for (int i = 0; i < often; ++i) {
    panel.surprise(document);
    color_changed = color_changed || document.scene.air.color != Scene{}.air.color;
    ASSERT_EQ(document.scene.air.density, Scene{}.air.density);
  }
  EXPECT_TRUE(color_changed);
}

}  // namespace
}  // namespace terrella
