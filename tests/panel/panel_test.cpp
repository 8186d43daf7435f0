#include "panel/panel.hpp"

#include "base/text.hpp"
#include "hand.hpp"
#include "scene/json.hpp"
#include "scene/presets.hpp"
#include "scene/quality_path.hpp"

namespace terrella {
namespace {

const Scene& scene_of(const std::string& preset) { return find_preset(preset)->scene; }

// What would be found wrong with any value of a scene.
std::vector<std::string> faults(const Scene& scene) {
  std::vector<std::string> sentences;
  Scene copy;
  for (const Parameter& parameter : parameters()) {
    if (const auto issue = assign(copy, parameter, parameter.get(scene))) sentences.push_back(issue->text());
  }
  return sentences;
}

TEST_F(PanelTest, OffersTheWholeScreenOnlyWhereItCanBeHad) {
  EXPECT_EQ(count_of("fill_screen"), 0);
  facts.can_fill_screen = true;
  frames(2);
  EXPECT_TRUE(click("fill_screen").fill_screen);
  const WidgetPlace first = place_of("undo"), last = place_of("fold");
  EXPECT_LT(place_of("title").right, first.left);
  EXPECT_LE(last.right, 340.0F);
}

TEST_F(PanelTest, EveryGroupHasAHeaderAndEveryParameterAWidget) {
  for (const Group& group : groups()) EXPECT_EQ(count_of(group.name), 1) << group.name;
  open_all_groups();
  for (const Parameter& parameter : parameters()) EXPECT_EQ(count_of(parameter.path), 1) << parameter.path;
}

TEST_F(PanelTest, ValuesStayInRangeAtTheEndsOfTheirSliders) {
  open_all_groups();
  for (const float end : {-0.5F, 1.5F}) {
    for (const Parameter& parameter : parameters()) {
      if (parameter.type != Type::Float && parameter.type != Type::Int) continue;
      drag(std::string(parameter.path), 0.4F, end);
      ASSERT_EQ(faults(document.scene), std::vector<std::string>{}) << parameter.path << " at " << end;
    }
  }
  EXPECT_EQ(document.scene.waves.steepness, 1.0);
  EXPECT_EQ(document.scene.waves.count, 1000);
}

TEST_F(PanelTest, AHeldSliderIsDraggedUntilItIsLetGo) {
  click("waves");
  point_at("waves.steepness", 0.2F);
  const PanelWishes pressed = press();
  EXPECT_TRUE(pressed.dragging);
  EXPECT_TRUE(pressed.scene_changed);
  EXPECT_NEAR(document.scene.waves.steepness, 0.2, 0.05);
  const PanelWishes held = frame();
  EXPECT_TRUE(held.dragging);
  EXPECT_FALSE(held.scene_changed);
  release();
  EXPECT_FALSE(frame().dragging);
}

TEST_F(PanelTest, ASliderKeepsItsValueWhileThePointerIsOutsideOfTheWindow) {
  click("waves");
  point_at("waves.steepness", 0.7F);
  press();
  const double before = document.scene.waves.steepness;
  ImGui::GetIO().AddMousePosEvent(-FLT_MAX, -FLT_MAX);
  frame();
  EXPECT_EQ(document.scene.waves.steepness, before);
}

TEST_F(PanelTest, ALengthsSliderGrowsWithThePlanet) {
  document.scene.planet.radius = 1000.0;
  click("terrain");
  drag("terrain.height", 0.5F, 1.5F);
  EXPECT_EQ(document.scene.terrain.height, 500.0);
}

TEST_F(PanelTest, OneValueGoesBackToThePreset) {
  click("waves");
  EXPECT_EQ(count_of("waves.steepness/reset"), 0);
  document.scene.waves.steepness = 0.1;
  document.scene.waves.spread = 0.1;
  frame();
  EXPECT_TRUE(click("waves.steepness/reset").scene_changed);
  EXPECT_EQ(document.scene.waves.steepness, Scene{}.waves.steepness);
  EXPECT_EQ(document.scene.waves.spread, 0.1);
  EXPECT_EQ(count_of("waves.steepness/reset"), 0);
}

TEST_F(PanelTest, AGroupGoesBackToThePreset) {
  document = {scene_of("storm"), "storm"};
  document.scene.waves.steepness = 0.1;
  document.scene.clouds.color = {1, 2, 3};
  frame();
  EXPECT_TRUE(click("clouds/reset").scene_changed);
  EXPECT_EQ(document.scene.clouds, scene_of("storm").clouds);
  EXPECT_EQ(document.scene.waves.steepness, 0.1);
}

TEST_F(PanelTest, AllGoesBackToThePreset) {
  document = {scene_of("storm"), "storm"};
  frame();
  EXPECT_EQ(click("reset_all"), PanelWishes{});
  document.scene.waves.steepness = 0.1;
  document.scene.planet.radius = 12.0;
  frame();
  EXPECT_TRUE(click("reset_all").scene_replaced);
  EXPECT_EQ(document, (SceneDocument{scene_of("storm"), "storm"}));
}

TEST_F(PanelTest, AListOfPresetsShowsThePicturesThereAre) {
  constexpr unsigned first = 1001;
  facts.preset_pictures = {first, first + 1, first + 2};
  const auto drawn = [&] {
    std::size_t count = 0;
    for (const ImDrawList* list : ImGui::GetDrawData()->CmdLists) {
      for (const ImDrawCmd& command : list->CmdBuffer) {
        const ImTextureID texture = command.GetTexID();
        for (const unsigned picture : facts.preset_pictures) count += texture == ImTextureID(std::uintptr_t{picture});
      }
    }
    return count;
  };
  frame();
  EXPECT_FALSE(panel.shows_presets());
  EXPECT_EQ(drawn(), 0U);
  click("preset");
  EXPECT_TRUE(panel.shows_presets());
  EXPECT_EQ(drawn(), facts.preset_pictures.size());
  tap(ImGuiKey_Escape);
  EXPECT_FALSE(panel.shows_presets());
}

TEST_F(PanelTest, APresetReplacesTheScene) {
  document.scene.waves.steepness = 0.1;
  click("preset");
  for (const Preset& preset : presets()) EXPECT_EQ(count_of("preset/" + preset.name), 1) << preset.name;
  const PanelWishes wishes = click("preset/storm");
  EXPECT_TRUE(wishes.scene_replaced);
  EXPECT_TRUE(wishes.preset_chosen);
  EXPECT_EQ(document, (SceneDocument{scene_of("storm"), "storm"}));
}

TEST_F(PanelTest, ChoicesAndSwitchesAndSeeds) {
  open_all_groups();
  click("water.shading");
  EXPECT_TRUE(click("water.shading/phong").scene_changed);
  EXPECT_EQ(choice_name(document.scene, "water.shading"), "phong");
  click("terrain.ridged");
  EXPECT_TRUE(document.scene.terrain.ridged);
  click("planet.seed", 0.97F);  // its plus
  EXPECT_EQ(document.scene.planet.seed, Scene{}.planet.seed + 1);
}

TEST_F(PanelTest, AColorIsTypedAsHex) {
  click("air");
  click("air.color", 0.3F);
  ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, true);
  tap(ImGuiKey_A);
  ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, false);
  type("#0a141e");
  tap(ImGuiKey_Enter);
  EXPECT_EQ(to_text(document.scene.air.color), "#0a141e");
}

TEST_F(PanelTest, NumbersCanBeTyped) {
  click("terrain");
  type_into("terrain.height", "2.5 mm");
  EXPECT_EQ(document.scene.terrain.height, 0.0025);
  type_into("terrain.height", "7");  // in millimetres, as it was shown
  EXPECT_EQ(document.scene.terrain.height, 0.007);
  type_into("terrain.octaves", "7.4");
  EXPECT_EQ(document.scene.terrain.octaves, 7);
  type_into("terrain.power", "1e300");
  EXPECT_EQ(document.scene.terrain.power, 16.0);
}

TEST_F(PanelTest, WhatIsNoNumberChangesNothing) {
  click("terrain");
  for (const std::string text : {"", "high", "nan", "-", "0x10 km", "\u00b5"}) {
    type_into("terrain.power", text);
    EXPECT_EQ(document.scene, Scene{}) << text;
  }
  type_into("terrain.power", "3", ImGuiKey_Escape);
  EXPECT_EQ(document.scene, Scene{});
}

TEST_F(PanelTest, TypingIsNotDragging) {
  click("terrain");
  ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, true);
  click("terrain.power");
  ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, false);
  frames(3);
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
  EXPECT_FALSE(frame().dragging);
}

TEST_F(PanelTest, AFrameInWhichNothingHappensWishesNothing) {
  EXPECT_EQ(frame(), PanelWishes{});
  open_all_groups();
  EXPECT_EQ(frame(), PanelWishes{});
  for (const Parameter& parameter : parameters()) {
    point_at(std::string(parameter.path));
    ASSERT_EQ(frame(), PanelWishes{}) << parameter.path;
  }
  EXPECT_EQ(document, SceneDocument{});
}

TEST_F(PanelTest, ButtonsWishWhatTheySay) {
  EXPECT_TRUE(click("copy_link").copy_link);
  EXPECT_TRUE(click("copy_json").copy_json);
  EXPECT_TRUE(click("save").save_json);
  EXPECT_TRUE(click("open").open_json);
  EXPECT_EQ(document, SceneDocument{});
}

TEST_F(PanelTest, APictureIsSavedInTheSizeChosen) {
  facts.width = 1280;
  facts.height = 720;
  facts.largest_picture = 4000;
  EXPECT_EQ(click("save_picture"), PanelWishes{});
  EXPECT_EQ(count_of("picture/8k"), 0);  // too large here
  EXPECT_EQ(click("picture/window").save_picture, (PictureWish{1280, 720, false}));
  EXPECT_EQ(count_of("picture/window"), 0);  // closed
  click("save_picture");
  EXPECT_EQ(click("picture/transparent", 0.1F), PanelWishes{});
  EXPECT_EQ(click("picture/full_hd").save_picture, (PictureWish{1920, 1080, true}));
  click("save_picture");
  click("picture/transparent", 0.1F);
  type_into("picture/width", "640");
  type_into("picture/height", "99999", ImGuiKey_Tab);
  EXPECT_EQ(click("picture/own").save_picture, (PictureWish{640, 4000, false}));
  EXPECT_EQ(count_of("picture/own"), 0);
}

TEST_F(PanelTest, UndoAndRedoAreWishedWhereThereIsSomething) {
  EXPECT_EQ(click("undo"), PanelWishes{});
  EXPECT_EQ(click("redo"), PanelWishes{});
  facts.can_undo = facts.can_redo = true;
  frame();
  EXPECT_TRUE(click("undo").undo);
  EXPECT_TRUE(click("redo").redo);
}

TEST_F(PanelTest, SaysWhereThePlanetIsShownAsItWasOpened) {
  const float below = place_of("preset").top;
  facts.comparing = true;
  frames(2);
  EXPECT_EQ(count_of("title/compared"), 1);
  EXPECT_LT(place_of("title/compared").right, place_of("undo").left);
  EXPECT_EQ(place_of("preset").top, below);  // nothing jumps
}

TEST_F(PanelTest, FoldsToAButtonAndBack) {
  click("fold");
  frame();
  EXPECT_EQ(count_of("terrain"), 0);
  EXPECT_EQ(count_of("unfold"), 1);
  click("unfold");
  frame();
  EXPECT_EQ(count_of("terrain"), 1);
  EXPECT_EQ(count_of("unfold"), 0);
}

TEST_F(PanelTest, TheClockStopsGoesOnAndIsMoved) {
  EXPECT_EQ(click("pause").paused, true);
  facts.paused = true;
  EXPECT_EQ(click("pause").paused, false);
  facts.seconds = 12.0;
  frame();
  point_at("seconds", 0.5F);
  press();
  frame();
  ImGui::GetIO().AddMousePosEvent(ImGui::GetIO().MousePos.x + 40.0F, ImGui::GetIO().MousePos.y);
  const PanelWishes wishes = frame();
  release();
  ASSERT_TRUE(wishes.seconds);
  EXPECT_GT(*wishes.seconds, 12.0);
  EXPECT_EQ(click("seconds/reset").seconds, 0.0);
}

TEST_F(PanelTest, FactsOfAnySizeAreShown) {
  facts.frame_ms = 16.7;
  facts.triangles = facts.gpu_bytes = facts.noise_evaluations = INT64_MAX;
  facts.renderer = "a renderer";
  facts.decisions = {{"waves.steepness", "0.4", "a crest would fold over"}, {"air", "none", "%n"}};
  frame();
  click("statistics");
  click("decisions");
  EXPECT_EQ(frame(), PanelWishes{});
}

class NarrowPanelTest : public PanelTest {
 protected:
  NarrowPanelTest() : PanelTest(200.0F, 300.0F) {}
};

TEST_F(NarrowPanelTest, ThePanelLeavesATenthOfANarrowWindow) {
  click("terrain", 0.3F);
  for (const WidgetPlace& place : places) EXPECT_LE(place.right, 192.0F) << place.name;
}

TEST_F(PanelTest, QualityIsChosenByNameOrHeldByItself) {
  click("quality");
  click("quality/preset");
  click("quality/preset/fast");
  EXPECT_TRUE(has_quality(document.scene, *find_quality("fast")));
  click("quality/preset");
  click("quality/preset/automatic");
  EXPECT_GT(document.scene.quality.target_ms, 0.0);
  click("quality/preset");
  click("quality/preset/reference");
  EXPECT_EQ(document.scene.quality.target_ms, 0.0);
  EXPECT_TRUE(has_quality(document.scene, *find_quality("reference")));
}

TEST_F(PanelTest, HowHandsMoveTheCameraIsChosenAboveItsParameters) {
  click("camera", 0.3F);
  frames(2);
  EXPECT_LT(place_of("camera/walk").bottom, place_of("camera.latitude").top + 1.0F);
  EXPECT_EQ(click("camera/walk").camera_mode, CameraMode::walk);
  EXPECT_EQ(click("camera/fly").camera_mode, CameraMode::fly);
  EXPECT_EQ(click("camera/orbit").camera_mode, std::nullopt);  // is on
  facts.camera_mode = CameraMode::fly;
  EXPECT_EQ(click("camera/orbit").camera_mode, CameraMode::orbit);
  EXPECT_EQ(click("camera/fly").camera_mode, std::nullopt);
}

TEST_F(PanelTest, SaysWhatWasGivenUpForATime) {
  click("quality");
  frames(3);
  const float before = place_of("quality.pixel_error").top;
  document.scene.quality.target_ms = 16.0;
  facts.quality = &quality_path().front();
  frames(3);
  const float given_up = place_of("quality.pixel_error").top;
  EXPECT_GT(given_up, before + 60.0F);  // four lines or more
  facts.quality = &quality_path().back();
  frames(3);
  EXPECT_GT(place_of("quality.pixel_error").top, before);
  EXPECT_LT(place_of("quality.pixel_error").top, given_up);
}

}  // namespace
}  // namespace terrella
