// Where the panel lies: as a sheet under the planet on a phone, and what fingers do to it there.
#include "hand.hpp"

namespace terrella {
namespace {

class SheetTest : public PanelTest {
 protected:
  SheetTest() : PanelTest(390.0F, 844.0F) {
    style_panel(1.0F, true);
    unsigned char* pixels = nullptr;
    int columns = 0, rows = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &columns, &rows);
    panel.put_below(true);
    frames(3);
  }

  void finger(ImVec2 place) {
    ImGui::GetIO().AddMouseSourceEvent(ImGuiMouseSource_TouchScreen);
    ImGui::GetIO().AddMousePosEvent(place.x, place.y);
    frame();
  }

  ImVec2 middle_of(const std::string& name) const {
    const WidgetPlace place = place_of(name);
    return {(place.left + place.right) * 0.5F, (place.top + place.bottom) * 0.5F};
  }

  // Puts a finger on a widget, draws it by so much and lets go.
  void draw(const std::string& name, ImVec2 by) {
    const ImVec2 from = middle_of(name);
    finger(from);
    press();
    for (int i = 1; i <= 10; ++i) {
      const float part = static_cast<float>(i) / 10.0F;
      finger({from.x + part * by.x, from.y + part * by.y});
    }
    release();
    frames(2);
  }

  // So that the sliders of a few parameters are in sight.
  void search(const std::string& text) {
    click("unfold");
    panel.start_search();
    frames(8);
    type(text);
    tap(ImGuiKey_Enter);
  }

  double terrain_height() const { return document.scene.terrain.height; }
};

TEST(PanelPlace, IsBelowInNarrowWindowsAndUnderFingersHeldUpright) {
  EXPECT_TRUE(panel_lies_below(390, 844, true));
  EXPECT_TRUE(panel_lies_below(390, 844, false));
  EXPECT_TRUE(panel_lies_below(820, 1180, true));
  EXPECT_FALSE(panel_lies_below(820, 1180, false));
  EXPECT_FALSE(panel_lies_below(844, 390, true));
  EXPECT_FALSE(panel_lies_below(1280, 720, false));
}

TEST_F(SheetTest, IsFoldedToAHandleAtFirst) {
  ASSERT_EQ(count_of("unfold"), 1);
  EXPECT_EQ(count_of("fold"), 0);
  const WidgetPlace handle = place_of("unfold");
  EXPECT_NEAR((handle.left + handle.right) * 0.5F, 195.0F, 1.0F);
  EXPECT_GT(handle.bottom, 800.0F);
  EXPECT_LE(handle.bottom, 844.0F);
  EXPECT_EQ(panel.covered_below(), 0.0F);
}

TEST_F(SheetTest, UnfoldsOverTheWholeWidthAndHidesLessThanHalf) {
  click("unfold");
  EXPECT_NEAR(panel.covered_below(), 0.45F * 844.0F, 1.0F);
  for (const WidgetPlace& place : places) {
    EXPECT_GE(place.left, 0.0F) << place.name;
    EXPECT_LE(place.right, 390.0F) << place.name;
    EXPECT_GE(place.top, 844.0F - panel.covered_below()) << place.name;
  }
  click("fold");
  EXPECT_EQ(panel.covered_below(), 0.0F);
}

TEST_F(SheetTest, IsHighEnoughForFingers) {
  EXPECT_GE(place_of("unfold").bottom - place_of("unfold").top, 44.0F);
  search("terrain.height");
  EXPECT_EQ(count_of("terrain.height"), 1);
  for (const WidgetPlace& place : places) {
    const bool pressed = place.name != "terrain" && place.name != "title";  // these are words
    if (pressed) {
      EXPECT_GE(place.bottom - place.top, 44.0F) << place.name;
    }
  }
}

TEST_F(SheetTest, LiesAtTheLeftUnfoldedWhenTurned) {
  panel.put_below(false);
  ImGui::GetIO().DisplaySize = {844.0F, 390.0F};
  frames(3);
  ASSERT_EQ(count_of("fold"), 1);
  EXPECT_LT(place_of("fold").top, 60.0F);
  EXPECT_EQ(panel.covered_below(), 0.0F);
}

TEST_F(SheetTest, AFingerDrawnUpScrollsAndChangesNothing) {
  click("unfold");
  const SceneDocument before = document;
  const float top = place_of("preset").top, fixed = place_of("fold").top;
  draw("preset", {3.0F, -90.0F});
  EXPECT_EQ(count_of("preset/moon"), 0);  // nor did the list open
  EXPECT_NEAR(place_of("preset").top, top - 90.0F, 12.0F);
  EXPECT_EQ(place_of("fold").top, fixed);
  EXPECT_EQ(document, before);
}

TEST_F(SheetTest, AFingerScrollsOverSlidersAndDrawsThemOnlyAlong) {
  search("terrain");
  const double before = terrain_height();
  draw("search", {0.0F, -180.0F});
  const float top = place_of("terrain.height").top;
  draw("terrain.height", {10.0F, -80.0F});
  EXPECT_EQ(terrain_height(), before);
  EXPECT_LT(place_of("terrain.height").top, top - 50.0F);
  draw("terrain.height", {0.0F, 80.0F});
  EXPECT_EQ(terrain_height(), before);
  draw("terrain.height", {60.0F, 10.0F});
  EXPECT_GT(terrain_height(), before);
  EXPECT_FALSE(frame().dragging);
}

TEST_F(SheetTest, ATapTakesTheSliderToTheFinger) {
  search("terrain.height");
  const double before = terrain_height();
  draw("terrain.height", {0.0F, 0.0F});
  const double tapped = terrain_height();
  EXPECT_NE(tapped, before);
  EXPECT_EQ(count_of("terrain.height"), 1);
}

}  // namespace
}  // namespace terrella
