#include "panel/keys.hpp"

#include <imgui_internal.h>  // whether a window scrolls

#include <fstream>
#include <sstream>

#include "hand.hpp"

namespace terrella {
namespace {

TEST(Keys, AreSaidInTheDocumentsAsInTheProgram) {
  std::ifstream file(TERRELLA_SOURCE_DIR "/docs/keys.md");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), keys_text()) << "build/native/terrella keys > docs/keys.md";
}

TEST(Keys, AreShortAndOfTheFontsLetters) {
  for (const KeyGroup& group : key_groups()) {
    for (const KeyLine& line : group.lines) {
      EXPECT_LE(line.keys.size(), 28U) << line.keys;
      for (const char c : std::string(line.keys) + std::string(line.does)) EXPECT_TRUE(c >= ' ' && c <= '~') << c;
    }
  }
}

TEST_F(PanelTest, TheListOfKeysComesAndGoes) {
  EXPECT_EQ(count_of("keys/close"), 0);
  panel.toggle_keys();
  frames(2);
  EXPECT_EQ(count_of("keys/close"), 1);
  panel.toggle_keys();
  frames(2);
  EXPECT_EQ(count_of("keys/close"), 0);
  click("keys");
  click("keys/close");
  frames(2);
  EXPECT_EQ(count_of("keys/close"), 0);
}

class SmallScreenTest : public PanelTest {
 protected:
  SmallScreenTest() : PanelTest(1280.0F, 720.0F) {}
};

TEST_F(SmallScreenTest, TheWholeListOfKeysIsInSight) {
  panel.toggle_keys();
  frames(4);
  const ImGuiWindow* const window = ImGui::FindWindowByName("keys");
  ASSERT_NE(window, nullptr);
  EXPECT_EQ(window->ScrollMax.y, 0.0F);
  EXPECT_LT(window->Size.y, 720.0F);
}

TEST_F(PanelTest, EscapeClosesTheListOfKeysAndLeavesTheSearch) {
  panel.start_search();
  frames(3);
  type("steepness");
  tap(ImGuiKey_Enter);
  panel.toggle_keys();
  frames(2);
  tap(ImGuiKey_Escape);
  EXPECT_EQ(count_of("keys/close"), 0);
  EXPECT_EQ(count_of("terrain"), 0);
  tap(ImGuiKey_Escape);
  EXPECT_EQ(count_of("terrain"), 1);
}

}  // namespace
}  // namespace terrella
