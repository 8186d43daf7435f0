// How the program ends, and how it does not begin.
#include <gtest/gtest.h>

#include "window/patience.hpp"
#include "window/window_fixture.hpp"

namespace terrella::test {
namespace {

TEST_F(UsersWindowTest, EndsWellWhenTheWindowIsClosed) {
  EXPECT_FALSE(program->ended());
  EXPECT_EQ(close_window(), 0);
}

TEST_F(UsersWindowTest, EndsWellWhenItIsClosedWhileItFillsTheScreen) {
  hands->tap({"Shift_L", "f"});
  ASSERT_TRUE(until([this] {
    const auto place = screen->place_of_window("Terrella");
    return place && place->height == Screen::height;
  }));
  EXPECT_EQ(close_window(), 0);
}

TEST_F(WindowTest, WithoutADisplayItSaysSo) {
  const std::string said = folder / "said";
  auto started =
      Child::start({{TERRELLA_PROGRAM, "view"}, {"DISPLAY", "WAYLAND_DISPLAY", "HOME=" + home.string()}, folder, said});
  ASSERT_TRUE(started) << started.sentence();
  ASSERT_TRUE(until([&] { return started->ended().has_value(); }));
  EXPECT_EQ(started->ended(), 1);
  const std::string words = text_of_file(said);
  EXPECT_TRUE(words.starts_with("No window can be opened here: ")) << words;
  EXPECT_TRUE(words.ends_with(".\n")) << words;
}

}  // namespace
}  // namespace terrella::test
