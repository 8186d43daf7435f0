// A panel that goes on where another was.
#include "panel/panel_state.hpp"

#include "hand.hpp"

namespace terrella {
namespace {

PanelMemory memory_at_work() {
  PanelMemory memory;
  memory.open = {"air", "terrain"};
  memory.folded = true;
  memory.chance.locked = {"terrain.height", "water.level"};
  std::string_view("sea level").copy(memory.search.text.data(), memory.search.text.size());
  memory.scrolling.at = 120.5F;
  memory.keyboard.here = true;
  memory.tour = {true, 2, {}, false};
  memory.picture = {640, 480, true};
  memory.mix.preset = "storm";
  memory.mix.share = 0.25;
  memory.mix.from.water.level = 0.1;
  memory.mix.mixed.water.level = 0.2;
  return memory;
}

TEST(PanelState, IsTakenOnByAnother) {
  const PanelMemory before = memory_at_work();
  NamedLines lines;
  lines.add("news", "1 2 3");
  add_state(before, lines);
  PanelMemory after;
  take_state(after, lines.text());
  EXPECT_EQ(after.open, before.open);
  EXPECT_EQ(after.folded, before.folded);
  EXPECT_EQ(after.chance.locked, before.chance.locked);
  EXPECT_STREQ(after.search.text.data(), "sea level");
  EXPECT_EQ(after.scrolling.wanted, 120.5F);
  EXPECT_TRUE(after.keyboard.wanted);
  EXPECT_TRUE(after.tour.wanted);
  EXPECT_EQ(after.tour.step, 2);
  EXPECT_EQ(after.picture.width, 640);
  EXPECT_EQ(after.picture.height, 480);
  EXPECT_TRUE(after.picture.transparent);
  EXPECT_EQ(after.mix.preset, "storm");
  EXPECT_EQ(after.mix.share, 0.25);
  EXPECT_EQ(after.mix.from, before.mix.from);
  EXPECT_EQ(after.mix.mixed, before.mix.mixed);
}

TEST(PanelState, OfAVersionThatKnowsOtherNamesTheKnownOnesCount) {
  PanelMemory memory;
  take_state(memory, "locked terrain.depth\nlocked water.level\nmix_preset strom\nmix_share much\n");
  EXPECT_EQ(memory.chance.locked, Locks{"water.level"});
  EXPECT_EQ(memory.mix.preset, "");
  EXPECT_EQ(memory.mix.share, 0.0);
}

class LowPanelTest : public PanelTest {
 protected:
  LowPanelTest() : PanelTest(1280.0F, 500.0F) {}
};

TEST_F(LowPanelTest, IsScrolledAsFarAsTheOtherWas) {
  panel.take_habits("terrain");
  frames(3);
  const float top = place_of("terrain").top;
  panel.take_state("scrolled 90\n");
  frames(6);
  EXPECT_NEAR(place_of("terrain").top, top - 90.0F, 1.0F);
  NamedLines lines;
  panel.add_state(lines);
  EXPECT_NE(lines.text().find("scrolled 90\n"), std::string::npos);
}

}  // namespace
}  // namespace terrella
