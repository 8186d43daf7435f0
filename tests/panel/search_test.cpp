#include "panel/search.hpp"

#include "hand.hpp"

namespace terrella {
namespace {

std::vector<std::string> paths_about(std::string_view text) {
  std::vector<std::string> paths;
  for (const Parameter* parameter : parameters_about(text)) paths.emplace_back(parameter->path);
  return paths;
}

TEST(Search, FindsByPathNameHelpAndGroup) {
  EXPECT_EQ(paths_about("waves.steepness"), std::vector<std::string>{"waves.steepness"});
  EXPECT_EQ(paths_about("ridge sharpness"), std::vector<std::string>{"terrain.ridge_sharpness"});
  EXPECT_EQ(paths_about("field of view"), std::vector<std::string>{"camera.fov"});
  EXPECT_EQ(paths_about("Camera Field"), std::vector<std::string>{"camera.fov"});
}

TEST(Search, EveryWordMustBeFoundWhateverItsCase) {
  EXPECT_EQ(paths_about("  SAND   hEIGHT "), std::vector<std::string>{"terrain.sand_height"});
  EXPECT_TRUE(paths_about("sand zebra").empty());
}

TEST(Search, NoWordsMeanAll) {
  EXPECT_EQ(parameters_about("").size(), parameters().size());
  EXPECT_EQ(parameters_about("   ").size(), parameters().size());
}

TEST(Search, NamesTheNearest) {
  EXPECT_EQ(nothing_about("stepness"), "There is no \"stepness\"; did you mean steepness?");
  EXPECT_EQ(nothing_about("Wavs.Count"), "There is no \"Wavs.Count\"; did you mean waves.count?");
  EXPECT_EQ(nothing_about("ridge sharpnes x"), "There is no \"ridge sharpnes x\"; did you mean ridge sharpness?");
  EXPECT_EQ(nothing_about("zzzzzzzzzz"), "There is no \"zzzzzzzzzz\".");
}

class SearchTest : public PanelTest {
 protected:
  void search(const std::string& text) {
    panel.start_search();
    frames(3);
    type(text);
  }
};

TEST_F(SearchTest, TypingShowsTheHitsOfAllGroupsAndNothingElse) {
  search("steepness");
  EXPECT_EQ(count_of("waves"), 1);
  EXPECT_EQ(count_of("waves.steepness"), 1);
  EXPECT_EQ(count_of("waves.spread"), 0);
  EXPECT_EQ(count_of("terrain"), 0);
  EXPECT_EQ(count_of("statistics"), 0);
  drag("waves.steepness", 0.2F, 0.8F);
  EXPECT_NEAR(document.scene.waves.steepness, 0.8, 0.05);
}

TEST_F(SearchTest, EscapeClearsItAndTheGroupsAreAsTheyWere) {
  click("terrain");
  search("steepness");
  EXPECT_EQ(count_of("terrain.height"), 0);
  tap(ImGuiKey_Escape);
  EXPECT_EQ(count_of("terrain.height"), 1);
  EXPECT_EQ(count_of("waves"), 1);
  EXPECT_EQ(count_of("waves.steepness"), 0);
  EXPECT_FALSE(ImGui::GetIO().WantTextInput);
}

TEST_F(SearchTest, EscapeClearsItAlsoFromOutsideOfTheField) {
  search("steepness");
  drag("waves.steepness", 0.2F, 0.8F);
  tap(ImGuiKey_Escape);
  EXPECT_EQ(count_of("terrain"), 1);
}

TEST_F(SearchTest, EscapeInANumberLeavesTheSearchAlone) {
  search("steepness");
  type_into("waves.steepness", "0.7", ImGuiKey_Escape);
  EXPECT_EQ(count_of("waves.steepness"), 1);
  EXPECT_EQ(count_of("terrain"), 0);
  EXPECT_EQ(document.scene, Scene{});
}

TEST_F(SearchTest, ComesBackAfterAHandOnThePlanetHasLeftIt) {
  search("steepness");
  ImGui::GetIO().AddMousePosEvent(900.0F, 3000.0F);
  frame();
  press();
  release();
  frames(3);
  tap(ImGuiKey_Escape);
  search("craters");
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
  EXPECT_EQ(count_of("terrain.craters"), 1);
}

TEST_F(SearchTest, ItsCrossClearsIt) {
  EXPECT_EQ(count_of("search/clear"), 0);
  search("steepness");
  click("search/clear");
  EXPECT_EQ(count_of("search/clear"), 0);
  EXPECT_EQ(count_of("terrain"), 1);
}

TEST_F(SearchTest, WhatIsNowhereShowsNoGroup) {
  search("zebra");
  for (const Group& group : groups()) EXPECT_EQ(count_of(group.name), 0) << group.name;
}

TEST_F(SearchTest, AFoldedPanelUnfoldsForIt) {
  click("fold");
  frame();
  search("steepness");
  EXPECT_EQ(count_of("waves.steepness"), 1);
}

class LowSearchTest : public PanelTest {
 protected:
  LowSearchTest() : PanelTest(1280.0F, 300.0F) {}
};

TEST_F(LowSearchTest, TheFieldComesBackFromAboveTheScrolledPanel) {
  click("camera", 0.3F);
  point_at("camera", 0.1F);
  for (int i = 0; i < 10; ++i) {
    ImGui::GetIO().AddMouseWheelEvent(0.0F, -3.0F);
    frame();
  }
  ASSERT_LT(place_of("search").bottom, 0.0F);
  panel.start_search();
  frames(5);
  EXPECT_GT(place_of("search").top, 0.0F);
  type("steepness");
  EXPECT_EQ(count_of("waves.steepness"), 1);
}

}  // namespace
}  // namespace terrella
