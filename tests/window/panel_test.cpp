// The keys that show and hide, and the habits that stay.
#include <gtest/gtest.h>

#include "window/patience.hpp"
#include "window/window_fixture.hpp"

namespace terrella::test {
namespace {

constexpr Box kKeysList{420, 40, 430, 600};

TEST_F(UsersWindowTest, HHidesThePanelAndBringsItBack) {
  const Picture before = settled();
  hands->tap({"h"});
  ASSERT_TRUE(changes(before, kGroups));
  const Picture without = settled();
  EXPECT_LT(brightness(without, kTitle), 15.0);
  EXPECT_GT(difference(without, before, kPlanet), 4.0);  // it stands in the middle of more room
  hands->tap({"h"});
  EXPECT_TRUE(becomes(before, kGroups));
  EXPECT_TRUE(becomes(before, kPlanet));
}

TEST_F(UsersWindowTest, AQuestionMarkListsTheKeys) {
  const Picture before = settled();
  hands->tap({"Shift_L", "slash"});
  ASSERT_TRUE(changes(before, kKeysList));
  hands->tap({"Shift_L", "slash"});
  EXPECT_TRUE(becomes(before, kKeysList));
}

TEST_F(UsersWindowTest, ShiftFFillsTheScreenAndLeavesIt) {
  const auto has_height = [this](int height) {
    return until([this, height] {
      const auto place = screen->place_of_window("Terrella");
      return place && place->width == 1280 && place->height == height;
    });
  };
  ASSERT_TRUE(has_height(720));
  const Picture before = settled();
  hands->tap({"Shift_L", "f"});
  ASSERT_TRUE(has_height(Screen::height));
  // The planet lies in the middle of more room, and keys still arrive.
  constexpr Box below{400, 690, 500, 10};
  EXPECT_TRUE(until([&] { return brightness(screen->picture(), below) > brightness(before, below) + 5.0; }));
  const Picture full = settled();
  hands->tap({"h"});
  EXPECT_TRUE(changes(full, kGroups));
  hands->tap({"h"});
  EXPECT_TRUE(becomes(full, kGroups));
  hands->tap({"Shift_L", "f"});
  ASSERT_TRUE(has_height(720));
  EXPECT_TRUE(becomes(before, kPlanet));
  EXPECT_TRUE(becomes(before, kGroups));
}

TEST_F(WindowTest, ShowsANewcomerAroundOnceAndKeepsItsHabits) {
  open_window();
  EXPECT_EQ(kept_habits(), "tour\n");
  const Picture tour = settled();
  hands->click(834, 607);  // skips it
  EXPECT_TRUE(changes(tour, kBubble));
  EXPECT_TRUE(until([this] { return kept_habits() == "\n"; })) << kept_habits();
  const Picture closed = settled();
  hands->click(60, 170);  // the first group
  hands->point(1200, 700);
  EXPECT_TRUE(changes(closed, kGroups));
  EXPECT_TRUE(until([this] { return kept_habits() == "planet\n"; })) << kept_habits();
  const Picture opened = settled();
  EXPECT_EQ(close_window(), 0);

  open_window();
  EXPECT_TRUE(becomes(opened, kGroups));
  EXPECT_TRUE(becomes(opened, kBubble));
  EXPECT_GT(difference(settled(), tour, kBubble), 4.0);
  EXPECT_EQ(kept_habits(), "planet\n");
}

}  // namespace
}  // namespace terrella::test
