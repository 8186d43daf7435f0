#include "panel/tour.hpp"

#include "hand.hpp"

namespace terrella {
namespace {

bool apart(const WidgetPlace& a, const WidgetPlace& b) {
  return a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
}

TEST_F(PanelTest, ThereIsNoTourUnlessItIsWanted) {
  EXPECT_EQ(count_of("tour/next"), 0);
  panel.take_habits("terrain");
  frames(2);
  EXPECT_EQ(count_of("tour/next"), 0);
}

TEST_F(PanelTest, TheTourHasFourBubblesAndThenIsOver) {
  panel.take_habits("tour");
  frames(3);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(panel.habits(), "tour") << i;
    EXPECT_EQ(count_of("tour/skip"), i < 3 ? 1 : 0) << i;
    EXPECT_EQ(click("tour/next"), PanelWishes{});
    frames(2);
  }
  EXPECT_EQ(count_of("tour/next"), 0);
  EXPECT_EQ(panel.habits(), "");
  EXPECT_EQ(document, SceneDocument{});
}

TEST_F(PanelTest, TheTourEndsWhenItIsSkipped) {
  panel.take_habits("tour");
  frames(3);
  click("tour/next");
  click("tour/skip");
  frames(2);
  EXPECT_EQ(count_of("tour/next"), 0);
  EXPECT_EQ(panel.habits(), "");
}

TEST_F(PanelTest, BubblesCoverNothingOfThePanelAndPointToTheirWidget) {
  panel.take_habits("tour");
  frames(3);
  for (const std::string target : {"", "preset", "terrain", "copy_link"}) {
    frames(2);
    const WidgetPlace next = place_of("tour/next");
    for (const WidgetPlace& place : places) {
      if (place.name.starts_with("tour/")) continue;
      EXPECT_TRUE(apart(place, next)) << place.name << " at " << target;
    }
    if (!target.empty()) {
      EXPECT_NEAR(next.top, place_of(target).top, 120.0F) << target;
    }
    click("tour/next");
  }
}

TEST_F(PanelTest, TheTourUnfoldsThePanelWhereItIsAboutIt) {
  panel.take_habits("tour folded");
  frames(3);
  EXPECT_EQ(count_of("unfold"), 1);
  click("tour/next");
  frames(2);
  EXPECT_EQ(count_of("fold"), 1);
  click("fold");
  frames(2);
  EXPECT_EQ(count_of("tour/next"), 0);
}

TEST_F(PanelTest, EscapeEndsTheTourButAnOpenListFirst) {
  panel.take_habits("tour");
  frames(3);
  click("preset");
  tap(ImGuiKey_Escape);
  EXPECT_EQ(count_of("tour/next"), 1);
  tap(ImGuiKey_Escape);
  EXPECT_EQ(count_of("tour/next"), 0);
  EXPECT_EQ(panel.habits(), "");
}

class PhonesPanelTest : public PanelTest {
 protected:
  PhonesPanelTest() : PanelTest(360.0F, 640.0F) {}
};

TEST_F(PhonesPanelTest, BubblesStayInTheWindow) {
  panel.put_at({true, true});
  panel.take_habits("tour");
  frames(3);
  for (int i = 0; i < 4; ++i) {
    frames(2);
    const WidgetPlace next = place_of("tour/next");
    EXPECT_GE(next.left, 0.0F) << i;
    EXPECT_LE(next.right, 360.0F) << i;
    EXPECT_LE(next.bottom, 640.0F) << i;
    EXPECT_GE(next.top, 0.0F) << i;
    click("tour/next");
  }
}

TEST_F(PhonesPanelTest, WhatABubbleIsAboutIsScrolledIntoSight) {
  panel.put_at({true, true});
  panel.take_habits("tour");
  frames(3);
  for (const std::string target : {"", "preset", "terrain", "copy_link"}) {
    frames(4);
    if (!target.empty()) {
      EXPECT_GT(place_of(target).top, place_of("fold").bottom) << target;
      EXPECT_LT(place_of(target).bottom, 640.0F) << target;
      EXPECT_LT(place_of("tour/next").bottom, place_of(target).top) << target;
    }
    click("tour/next");
  }
}

}  // namespace
}  // namespace terrella
