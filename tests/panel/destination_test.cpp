#include "panel/destination.hpp"

#include "hand.hpp"

namespace terrella {
namespace {

Destination place_of(std::string_view typed, double altitude = 1e6) {
  const auto read = read_destination(typed, altitude);
  const auto* there = std::get_if<Destination>(&read);
  if (there != nullptr) return *there;
  ADD_FAILURE() << std::get<std::string>(read);
  return {};
}

std::string sentence_about(std::string_view typed) {
  const auto read = read_destination(typed, 1.0);
  const auto* sentence = std::get_if<std::string>(&read);
  return sentence != nullptr ? *sentence : "";
}

TEST(Destination, IsReadAsPeopleTypeIt) {
  EXPECT_EQ(place_of("47.5, 8.2"), (Destination{47.5, 8.2, std::nullopt}));
  EXPECT_EQ(place_of("47.5, 8.2, 3 km"), (Destination{47.5, 8.2, 3000.0}));
  EXPECT_EQ(place_of(" -47.5° ,+8° , 3"), (Destination{-47.5, 8.0, 3000.0}));  // km, as it is told now
  EXPECT_EQ(place_of("-47.5,8,3", 20.0), (Destination{-47.5, 8.0, 3.0}));
  EXPECT_EQ(place_of("33 S; 70.5° w; 2 mm"), (Destination{-33.0, -70.5, 0.002}));
  EXPECT_EQ(place_of("33N, 70 E"), (Destination{33.0, 70.0, std::nullopt}));
  EXPECT_EQ(place_of("0, 270"), (Destination{0.0, -90.0, std::nullopt}));
  EXPECT_EQ(place_of("90, -180"), (Destination{90.0, -180.0, std::nullopt}));
}

TEST(Destination, SaysWhatIsWrong) {
  EXPECT_EQ(sentence_about("95, 8"), "camera.latitude: 95 is out of range; allowed are -90 to 90 deg.");
  EXPECT_EQ(sentence_about("5, 800"), "camera.longitude: 800 is out of range; allowed are -180 to 180 deg.");
  EXPECT_EQ(sentence_about("5, 8, -1 km"), "camera.altitude: -1000 is out of range; allowed are 0 to 1e12 m.");
  EXPECT_EQ(sentence_about("north, 8"), "camera.latitude: \"north\" is not a number; allowed are -90 to 90 deg.");
  for (const char* const no_place : {"", "47", "1, 2, 3, 4", "47.5 8.2"}) {
    EXPECT_NE(sentence_about(no_place).find("is no place"), std::string::npos) << no_place;
  }
}

TEST_F(PanelTest, APlaceIsTypedToGoTo) {
  click("camera");
  click("camera/go_to");
  frames(2);
  type("47.5, 8.2, 3 km");
  ImGui::GetIO().AddKeyEvent(ImGuiKey_Enter, true);
  std::optional<Destination> wish;
  for (int i = 0; i < 4; ++i) {
    const PanelWishes wishes = frame();
    if (wishes.go_to) wish = wishes.go_to;
    EXPECT_FALSE(wishes.scene_changed);
  }
  ImGui::GetIO().AddKeyEvent(ImGuiKey_Enter, false);
  frames(2);
  EXPECT_EQ(wish, (Destination{47.5, 8.2, 3000.0}));
  EXPECT_TRUE(document == SceneDocument{});
}

TEST_F(PanelTest, WhatIsNoPlaceIsSaidUntilTheNextIsTyped) {
  click("camera");
  const float before = place_of("camera.latitude").top;
  click("camera/go_to");
  frames(2);
  type("95, 8");
  tap(ImGuiKey_Enter);
  EXPECT_GT(place_of("camera.latitude").top, before);
  click("camera/go_to");
  frames(2);
  EXPECT_EQ(place_of("camera.latitude").top, before);
  tap(ImGuiKey_Escape);
  EXPECT_EQ(place_of("camera.latitude").top, before);
}

}  // namespace
}  // namespace terrella
