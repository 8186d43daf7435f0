// What a hand does to sliders beside dragging them.
#include "hand.hpp"
#include "panel/slider_range.hpp"

namespace terrella {
namespace {

class SliderHandTest : public PanelTest {
 protected:
  SliderHandTest() : SliderHandTest(6000.0F) {}
  explicit SliderHandTest(float height) : PanelTest(1280.0F, height) {}

  void control(bool down) {
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, down);
    frame();
  }

  PanelWishes turn_wheel(float notches) {
    ImGui::GetIO().AddMouseWheelEvent(0.0F, notches);
    return frame();
  }

  // Longer than the clicks of a double click lie apart.
  void wait() { frames(60); }

  double& steepness() { return document.scene.waves.steepness; }
};

TEST_F(SliderHandTest, TheWheelGoesInSmallSteps) {
  click("waves");
  steepness() = 0.5;
  point_at("waves.steepness");
  EXPECT_TRUE(turn_wheel(1.0F).scene_changed);
  EXPECT_NEAR(steepness(), 0.51, 1e-9);
  turn_wheel(-3.0F);
  EXPECT_NEAR(steepness(), 0.48, 1e-9);
  control(true);
  turn_wheel(1.0F);
  EXPECT_NEAR(steepness(), 0.481, 1e-9);
}

TEST_F(SliderHandTest, PartsOfANotchAreGathered) {
  click("terrain");
  document.scene.terrain.octaves = 7;
  point_at("terrain.octaves");
  for (int i = 0; i < 3; ++i) turn_wheel(0.3F);
  EXPECT_EQ(document.scene.terrain.octaves, 7);
  turn_wheel(0.3F);
  EXPECT_EQ(document.scene.terrain.octaves, 8);
}

TEST_F(SliderHandTest, TheWheelBesideASliderChangesNothing) {
  click("waves");
  point_at("waves.steepness", -0.3F);  // its name
  turn_wheel(1.0F);
  EXPECT_EQ(document.scene, Scene{});
}

TEST_F(SliderHandTest, WithControlItIsDraggedATenthAsFast) {
  click("waves");
  steepness() = 0.5;
  control(true);
  drag("waves.steepness", 0.1F, 0.6F);
  control(false);
  EXPECT_NEAR(steepness(), 0.55, 0.004);
  EXPECT_FALSE(ImGui::GetIO().WantTextInput);
}

TEST_F(SliderHandTest, ControlInTheMiddleOfADragSlowsItWithoutAJump) {
  click("waves");
  point_at("waves.steepness", 0.2F);
  press();
  point_at("waves.steepness", 0.5F);
  const double before = steepness();
  control(true);
  EXPECT_EQ(steepness(), before);
  point_at("waves.steepness", 0.6F);
  EXPECT_NEAR(steepness(), before + 0.01, 0.002);
  control(false);
  EXPECT_NEAR(steepness(), before + 0.01, 0.002);
  release();
}

TEST_F(SliderHandTest, AClickWithControlMovesNothingAndTypes) {
  click("waves");
  const double before = steepness();
  control(true);
  point_at("waves.steepness", 0.9F);
  EXPECT_FALSE(press().scene_changed);
  EXPECT_FALSE(release().scene_changed);
  control(false);
  frames(3);
  EXPECT_EQ(steepness(), before);
  type("0.25");
  tap(ImGuiKey_Enter);
  EXPECT_EQ(steepness(), 0.25);
}

TEST_F(SliderHandTest, ADoubleClickTypesOverTheValueBeforeIt) {
  click("waves");
  steepness() = 0.123;
  wait();
  point_at("waves.steepness", 0.9F);
  press();
  EXPECT_NEAR(steepness(), 0.9, 0.05);
  release();
  press();
  EXPECT_EQ(steepness(), 0.123);
  release();
  frames(3);
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
  tap(ImGuiKey_Escape);
  EXPECT_EQ(steepness(), 0.123);
  wait();
  click("waves.steepness", 0.9F);
  click("waves.steepness", 0.9F);
  type("0.25");
  tap(ImGuiKey_Enter);
  EXPECT_EQ(steepness(), 0.25);
}

TEST_F(SliderHandTest, TwoClicksFarApartAreNoDoubleClick) {
  click("waves");
  wait();
  click("waves.steepness", 0.8F);
  wait();
  click("waves.steepness", 0.8F);
  frames(3);
  EXPECT_FALSE(ImGui::GetIO().WantTextInput);
  EXPECT_NEAR(steepness(), 0.8, 0.05);
}

class LowSliderHandTest : public SliderHandTest {
 protected:
  LowSliderHandTest() : SliderHandTest(320.0F) { click("camera", 0.3F); }
  float top() const { return place_of("camera").top; }
};

TEST_F(LowSliderHandTest, TheWheelOnASliderDoesNotScrollThePanel) {
  const float before = top();
  point_at("camera.latitude");
  turn_wheel(-2.0F);
  frames(3);
  EXPECT_EQ(top(), before);
  EXPECT_LT(document.scene.camera.latitude, Scene{}.camera.latitude);
}

TEST_F(LowSliderHandTest, AWheelThatScrollsGoesOnAlthoughASliderComesUnderThePointer) {
  const float x = (place_of("camera.latitude").left + place_of("camera.latitude").right) * 0.5F;
  ImGui::GetIO().AddMousePosEvent(x, top() - 4.0F);
  frames(2);
  for (int i = 0; i < 8; ++i) {
    const float before = top();
    turn_wheel(-0.3F);
    frame();
    EXPECT_LT(top(), before) << i;
  }
  EXPECT_EQ(document.scene, Scene{});
}

TEST(SliderStep, NeverStandsStillBeforeTheEnd) {
  const Scene scene;
  for (const Parameter& parameter : parameters()) {
    if (parameter.type != Type::Float && parameter.type != Type::Int) continue;
    const SliderRange range = slider_range(parameter, scene);
    for (const double step : {0.1, 1.0, -0.1, -1.0}) {
      double value = step > 0.0 ? range.low : range.high;
      const double end = step > 0.0 ? range.high : range.low;
      int steps = 0;
      for (; value != end && steps < 5000; ++steps) {
        const double next = range.stepped(value, step);
        ASSERT_TRUE(step > 0.0 ? next > value : next < value) << parameter.path << ' ' << value;
        value = next;
      }
      EXPECT_EQ(value, end) << parameter.path;
      EXPECT_EQ(range.stepped(end, step), end) << parameter.path;
    }
  }
}

}  // namespace
}  // namespace terrella
