#include "hand.hpp"
#include "scene/morph.hpp"
#include "scene/presets.hpp"
#include "scene/view_groups.hpp"

namespace terrella {
namespace {

const Scene& scene_of(const std::string& preset) { return find_preset(preset)->scene; }

class MixTest : public PanelTest {
 protected:
  MixTest() {
    click("mix");
    click("mix/preset");
    click("mix/preset/lava");
  }
};

TEST_F(PanelTest, TheMixIsFoldedAwayUntilItIsWanted) {
  EXPECT_EQ(count_of("mix/share"), 0);
  click("mix");
  EXPECT_EQ(count_of("mix/share"), 1);
  click("mix");
  EXPECT_EQ(count_of("mix/share"), 0);
}

TEST_F(MixTest, ThePresetAloneChangesNothing) { EXPECT_EQ(document, SceneDocument{}); }

TEST_F(MixTest, LeadsToThePresetAndBackWithoutTheView) {
  document.scene.camera.longitude = 12.0;
  document.scene.quality.pixel_error = 2.0;
  const Scene start = document.scene;
  drag("mix/share", 0.01F, 1.2F);
  EXPECT_EQ(document.scene, seen_as(scene_of("lava"), start));
  drag("mix/share", 0.99F, -0.2F);
  EXPECT_EQ(document.scene, start);
}

TEST_F(MixTest, AHandOnItIsAHandOnAValue) {
  point_at("mix/share", 0.5F);
  const PanelWishes pressed = press();
  EXPECT_TRUE(pressed.scene_changed);
  EXPECT_TRUE(pressed.dragging);
  EXPECT_FALSE(frame().scene_changed);
  release();
  EXPECT_FALSE(frame().dragging);
}

TEST_F(MixTest, GoesOnFromItsBeginningWhileOnlyTheViewChanges) {
  drag("mix/share", 0.01F, 0.5F);
  document.scene.camera.altitude = 0.5;
  frame();
  drag("mix/share", 0.5F, -0.2F);
  Scene expected;
  expected.camera.altitude = 0.5;
  EXPECT_EQ(document.scene, expected);
}

TEST_F(MixTest, BeginsAnewWhereThePlanetWasChanged) {
  drag("mix/share", 0.01F, 0.5F);
  document.scene.terrain.power = 1.0;
  const Scene changed = document.scene;
  frame();
  drag("mix/share", 0.3F, -0.2F);
  EXPECT_EQ(document.scene, changed);
}

TEST_F(MixTest, AnotherPresetTakesThePlaceOfTheFirst) {
  drag("mix/share", 0.01F, 1.2F);
  click("mix/preset");
  EXPECT_TRUE(click("mix/preset/moon").scene_changed);
  EXPECT_EQ(document.scene, seen_as(scene_of("moon"), Scene{}));
}

TEST_F(MixTest, TheWheelGoesInSmallSteps) {
  point_at("mix/share");
  ImGui::GetIO().AddMouseWheelEvent(0.0F, 3.0F);
  frame();
  EXPECT_EQ(document.scene, seen_as(morph(Scene{}, scene_of("lava"), 0.03), Scene{}));
}

}  // namespace
}  // namespace terrella
