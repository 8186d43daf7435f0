// The panel by keyboard alone.
#include <imgui.h>
#include <imgui_internal.h>  // where the mark is

#include <cmath>

#include "hand.hpp"

namespace terrella {
namespace {

class KeyboardTest : public PanelTest {
 protected:
  void enter() {
    panel.take_keyboard();
    frames(3);
  }

  // Where the mark is; a widget's name, or nothing.
  std::string focused() {
    if (!panel.has_keyboard()) return {};
    const ImVec2 from = mark();
    for (const WidgetPlace& place : places) {
      if (std::abs(place.left - from.x) < 1.0F && std::abs(place.top - from.y) < 1.0F) return place.name;
    }
    return {};
  }

  // By Tab, at most around once.
  void go_to(const std::string& name) {
    for (int i = 0; i < 100 && focused() != name; ++i) tap(ImGuiKey_Tab);
    EXPECT_EQ(focused(), name);
  }

  // Of what Enter does, the first wish.
  PanelWishes press_key(ImGuiKey key) {
    PanelWishes first;
    for (const bool down : {true, false}) {
      ImGui::GetIO().AddKeyEvent(key, down);
      for (int i = 0; i < 3; ++i) {
        const PanelWishes wishes = frame();
        if (first == PanelWishes{}) first = wishes;
      }
    }
    return first;
  }

 private:
  static ImVec2 mark() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    if (context.NavWindow == nullptr) return {};
    return ImGui::WindowRectRelToAbs(context.NavWindow, context.NavWindow->NavRectRel[0]).Min;
  }
};

TEST_F(KeyboardTest, IsThePlanetsUntilItIsLedIn) {
  EXPECT_FALSE(panel.has_keyboard());
  enter();
  EXPECT_TRUE(panel.has_keyboard());
  EXPECT_EQ(focused(), "keys");  // there is nothing to undo
  tap(ImGuiKey_Escape);
  EXPECT_FALSE(panel.has_keyboard());
}

TEST_F(KeyboardTest, WalksToEveryButtonAndPressesIt) {
  enter();
  go_to("copy_link");
  EXPECT_TRUE(press_key(ImGuiKey_Enter).copy_link);
  tap(ImGuiKey_RightArrow);
  EXPECT_EQ(focused(), "copy_json");
  EXPECT_TRUE(press_key(ImGuiKey_Space).copy_json);
}

TEST_F(KeyboardTest, ChoosesAPreset) {
  enter();
  go_to("preset");
  tap(ImGuiKey_Enter);
  ASSERT_GT(count_of("preset/moon"), 0);
  tap(ImGuiKey_DownArrow);
  tap(ImGuiKey_Enter);
  EXPECT_NE(document.preset, SceneDocument{}.preset);
  EXPECT_TRUE(panel.has_keyboard());
  EXPECT_EQ(focused(), "preset");
}

TEST_F(KeyboardTest, EscapeClosesAListFirstAndThenLeaves) {
  enter();
  go_to("preset");
  tap(ImGuiKey_Enter);
  tap(ImGuiKey_Escape);
  EXPECT_EQ(count_of("preset/moon"), 0);
  EXPECT_TRUE(panel.has_keyboard());
  tap(ImGuiKey_Escape);
  EXPECT_FALSE(panel.has_keyboard());
}

TEST_F(KeyboardTest, ArrowsStepASliderAndEnterTypesIt) {
  enter();
  go_to("terrain");
  tap(ImGuiKey_Enter);
  go_to("terrain.height");
  const double before = document.scene.terrain.height;
  tap(ImGuiKey_RightArrow);
  const double stepped = document.scene.terrain.height;
  EXPECT_GT(stepped, before);
  EXPECT_EQ(focused(), "terrain.height");  // not its neighbour
  tap(ImGuiKey_LeftArrow);
  tap(ImGuiKey_LeftArrow);
  EXPECT_LT(document.scene.terrain.height, before);
  tap(ImGuiKey_Enter);
  frames(4);
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  type("250");
  tap(ImGuiKey_Enter);
  frames(3);
  EXPECT_EQ(document.scene.terrain.height, 0.25);  // of kilometres
  EXPECT_FALSE(ImGui::GetIO().WantTextInput);
  EXPECT_EQ(focused(), "terrain.height");
}

TEST_F(KeyboardTest, GoesOnFromWhereTheHandWas) {
  click("pause");
  EXPECT_FALSE(panel.has_keyboard());
  enter();
  EXPECT_EQ(focused(), "pause");
  tap(ImGuiKey_Escape);
  panel.start_search();
  frames(6);
  type("steepness");
  tap(ImGuiKey_Enter);
  ASSERT_FALSE(panel.has_keyboard());
  enter();
  EXPECT_EQ(focused(), "search");
  go_to("waves.steepness");
}

TEST_F(KeyboardTest, EscapeClosesTheListOfKeysFirst) {
  enter();
  ASSERT_EQ(focused(), "keys");
  tap(ImGuiKey_Enter);
  ASSERT_EQ(count_of("keys/close"), 1);
  tap(ImGuiKey_Escape);
  EXPECT_EQ(count_of("keys/close"), 0);
  EXPECT_TRUE(panel.has_keyboard());
}

TEST_F(KeyboardTest, StaysWhenThePanelFoldsAndUnfolds) {
  for (const bool below : {false, true}) {
    panel.put_at({below, below});
    frames(3);
    enter();
    if (count_of("unfold") > 0) tap(ImGuiKey_Enter);
    frames(3);
    go_to("fold");
    tap(ImGuiKey_Enter);
    frames(3);
    EXPECT_EQ(focused(), "unfold");
    tap(ImGuiKey_Enter);
    frames(3);
    EXPECT_EQ(focused(), "keys");
    tap(ImGuiKey_Escape);
  }
}

TEST_F(KeyboardTest, GoesDownTheRowsOfASheet) {
  panel.put_at({true, true});
  ImGui::GetIO().DisplaySize = {390.0F, 844.0F};
  frames(3);
  enter();
  tap(ImGuiKey_Enter);
  frames(3);
  go_to("water");  // far below its edge at first
  EXPECT_LT(place_of("water").bottom, 844.0F);
  tap(ImGuiKey_Escape);
  EXPECT_FALSE(panel.has_keyboard());
}

}  // namespace
}  // namespace terrella
