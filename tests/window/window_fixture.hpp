// The desktop program on a screen, with hands and eyes before it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "window/child.hpp"
#include "window/clipboard.hpp"
#include "window/hands.hpp"
#include "window/picture.hpp"
#include "window/screen.hpp"

namespace terrella::test {

// Parts of the window, in its pixels; it lies in the screen's top left corner.
inline constexpr Box kPlanet{560, 260, 160, 160}, kSky{1000, 20, 260, 160}, kTitle{14, 20, 70, 16},
    kGroups{14, 160, 330, 360}, kBubble{695, 524, 240, 100};

class WindowTest : public testing::Test {
 protected:
  WindowTest();
  ~WindowTest() override;
  void SetUp() override;
  // The program must not have suffered.
  void TearDown() override;

  // The scene of the tests, whose clock stands still, until its first whole picture is there.
  void open_window();
  // Asks it to close. Its exit code; nothing if it stays.
  std::optional<int> close_window();

  // How the screen looks once it has come to rest.
  Picture settled();
  // Waits until a part of the screen looks different or again (nearly) the same.
  bool changes(const Picture& before, const Box& box);
  bool becomes(const Picture& before, const Box& box);

  // By the panel's button.
  std::string copied_link();
  // By Ctrl+V. False if the program does not ask for it.
  bool paste(const std::string& text);

  [[nodiscard]] std::string kept_habits() const;

  const std::filesystem::path home, folder;  // the user's, and the one that the program runs in
  std::unique_ptr<Screen> screen;
  std::optional<Hands> hands;
  std::optional<Clipboard> clipboard;
  std::optional<Child> program;

 private:
  void see_window();
};

// Of one who has been here before.
class UsersWindowTest : public WindowTest {
 protected:
  void SetUp() override;
};

// The whole text of a file; empty if there is none.
std::string text_of_file(const std::filesystem::path& path);

}  // namespace terrella::test
