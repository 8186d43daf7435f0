// What the panel remembers from one frame to the next, beside what Dear ImGui does.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace terrella {

// A number that is being typed in the place of its slider.
struct Typing {
  std::string_view path;  // the parameter's; empty while nobody types
  std::array<char, 48> text{};
  std::string before;  // what the text was at first
  bool begun = false;  // the field has had the keyboard
  int frames_waited = 0;
};

// Which parameters are shown.
struct Search {
  std::array<char, 48> text{};
  bool wanted = false;  // the field shall have the keyboard
};

struct PanelMemory {
  bool folded = false;  // to a button in its corner
  Typing typing;
  Search search;
  std::string_view copied;  // the button that has just copied something, while the pointer rests on it
};

}  // namespace terrella
