#include "panel/habits.hpp"

#include "hand.hpp"

namespace terrella {
namespace {

TEST_F(PanelTest, HabitsTellWhatIsOpen) {
  EXPECT_EQ(panel.habits(), "");
  click("waves");
  click("statistics");
  click("terrain", 0.3F);
  click("mix");
  EXPECT_EQ(panel.habits(), "mix terrain waves statistics");
  click("terrain", 0.3F);
  click("fold");
  EXPECT_EQ(panel.habits(), "folded mix waves statistics");
}

TEST_F(PanelTest, HabitsAreTakenOnFromTheLastVisit) {
  panel.take_habits("air decisions\n");
  frames(2);
  EXPECT_EQ(count_of("air.height"), 1);
  EXPECT_EQ(count_of("waves.count"), 0);
  EXPECT_EQ(panel.habits(), "air decisions");
  click("air", 0.3F);
  EXPECT_EQ(count_of("air.height"), 0);
  panel.take_habits("folded");
  frames(2);
  EXPECT_EQ(count_of("unfold"), 1);
}

TEST_F(PanelTest, OfForeignHabitsTheKnownWordsCount) {
  for (const std::string text : {"", " ", "wavs", "FOLDED", "\x80"}) {
    panel.take_habits(text);
    EXPECT_EQ(panel.habits(), "") << text;
  }
  panel.take_habits("  waves   %s  lava\nwaves folded");
  EXPECT_EQ(panel.habits(), "folded waves");
  panel.take_habits(std::string(2 * kLongestHabits, 'x') + " waves");
  EXPECT_EQ(panel.habits(), "");
}

}  // namespace
}  // namespace terrella
