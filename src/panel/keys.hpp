// What all keys and movements of the mouse do, said once: for the window that lists them and for docs/keys.md.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace terrella {

struct KeyLine {
  std::string_view keys, does;
};

struct KeyGroup {
  std::string_view title;
  std::span<const KeyLine> lines;
  bool of_fingers = false;
};

std::span<const KeyGroup> key_groups();

// The whole table as Markdown.
std::string keys_text();

}  // namespace terrella
