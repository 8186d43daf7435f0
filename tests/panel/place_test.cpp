// Where the panel lies: as a sheet under the planet on a phone, and what fingers do to it there.
#include <imgui_internal.h>

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
    panel.put_at({true, true});
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

  // Puts a finger on a widget, draws it by so much, lets it rest for so many frames and lets go.
  void draw(const std::string& name, ImVec2 by, int rest = 20) {
    const ImVec2 from = middle_of(name);
    finger(from);
    press();
    for (int i = 1; i <= 10; ++i) {
      const float part = static_cast<float>(i) / 10.0F;
      finger({from.x + part * by.x, from.y + part * by.y});
    }
    frames(rest);
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

TEST(PanelPlace, IsBelowInNarrowWindowsAndUnderFingersHeldUprightAndFoldedOnPhones) {
  const PanelPlace sheet{true, true}, handle{false, true}, open{false, false};
  EXPECT_EQ(first_panel_place(390, 844, true), sheet);
  EXPECT_EQ(first_panel_place(390, 844, false), sheet);
  EXPECT_EQ(first_panel_place(820, 1180, true), sheet);
  EXPECT_EQ(first_panel_place(820, 1180, false), open);
  EXPECT_EQ(first_panel_place(844, 390, true), handle);
  EXPECT_EQ(first_panel_place(844, 390, false), open);
  EXPECT_EQ(first_panel_place(1180, 820, true), open);
  EXPECT_EQ(first_panel_place(1280, 720, false), open);
}

TEST_F(SheetTest, IsFoldedToAHandleAtFirst) {
  ASSERT_EQ(count_of("unfold"), 1);
  EXPECT_EQ(count_of("fold"), 0);
  const WidgetPlace handle = place_of("unfold");
  EXPECT_NEAR((handle.left + handle.right) * 0.5F, 195.0F, 1.0F);
  EXPECT_GT(handle.bottom, 800.0F);
  EXPECT_LE(handle.bottom, 844.0F);
  EXPECT_EQ(panel.covered().below, 0.0F);
}

TEST_F(SheetTest, UnfoldsOverTheWholeWidthAndHidesLessThanHalf) {
  click("unfold");
  EXPECT_NEAR(panel.covered().below, 0.45F * 844.0F, 1.0F);
  for (const WidgetPlace& place : places) {
    EXPECT_GE(place.left, 0.0F) << place.name;
    EXPECT_LE(place.right, 390.0F) << place.name;
    EXPECT_GE(place.top, 844.0F - panel.covered().below) << place.name;
  }
  click("fold");
  EXPECT_EQ(panel.covered().below, 0.0F);
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

TEST_F(SheetTest, LiesAtTheLeftWhenTurnedAndThePlanetMakesRoom) {
  panel.put_at({false, true});
  ImGui::GetIO().DisplaySize = {844.0F, 390.0F};
  frames(3);
  EXPECT_EQ(panel.covered(), Covered());
  click("unfold");
  frames(3);
  const WidgetPlace fold = place_of("fold");
  EXPECT_LT(fold.top, 60.0F);
  EXPECT_EQ(panel.covered().below, 0.0F);
  EXPECT_GT(panel.covered().left, fold.right);
  EXPECT_LT(panel.covered().left, fold.right + 30.0F);
  ImGui::GetIO().DisplaySize = {1920.0F, 1080.0F};
  frames(3);
  EXPECT_EQ(panel.covered(), Covered());  // there is room beside it
}

TEST_F(SheetTest, RunsOnWhenAFingerThrowsItAndAPressOnlyStopsIt) {
  click("unfold");
  const float top = place_of("preset").top;
  draw("preset", {0.0F, -60.0F}, 0);
  const float thrown = place_of("preset").top;
  EXPECT_TRUE(panel.moves());
  EXPECT_LT(thrown, top - 60.0F);
  frames(5);
  EXPECT_LT(place_of("preset").top, thrown);
  const SceneDocument before = document;
  const ImVec2 stop{195.0F, 700.0F};
  finger(stop);
  press();
  release();
  frames(2);
  EXPECT_FALSE(panel.moves());
  const float stopped = place_of("preset").top;
  frames(10);
  EXPECT_EQ(place_of("preset").top, stopped);
  EXPECT_EQ(document, before);
}

TEST_F(SheetTest, StandsWhereAFingerLeavesItAfterARest) {
  click("unfold");
  draw("preset", {0.0F, -60.0F});
  EXPECT_FALSE(panel.moves());
}

TEST_F(SheetTest, KeepsWhatIsTypedInSightOfAKeyboardOnTheScreen) {
  click("unfold");
  panel.start_search();
  frames(8);
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  ImGui::GetIO().DisplaySize = {390.0F, 500.0F};
  frames(5);
  EXPECT_GT(place_of("search").top, 500.0F - panel.covered().below);
  EXPECT_LT(place_of("search").bottom, 500.0F);
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

TEST_F(SheetTest, TheColourPickerLeavesThePlanetInSight) {
  search("air.color");
  click("air.color", 0.95F);
  const ImVector<ImGuiPopupData>& popups = ImGui::GetCurrentContext()->OpenPopupStack;
  ASSERT_EQ(popups.Size, 1);
  const ImRect picker = popups[0].Window->Rect();
  EXPECT_GE(picker.Min.x, 0.0F);
  EXPECT_LE(picker.Max.x, 390.0F);
  EXPECT_GE(picker.Min.y, 0.5F * 844.0F);
  EXPECT_LE(picker.Max.y, 844.0F);
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
