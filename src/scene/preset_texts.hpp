#pragma once

#include <span>
#include <string_view>

namespace terrella {

// A file of presets/: its name without the .json, and its content.
struct PresetText {
  std::string_view name;
  std::string_view json;
};

// All of them, in the order of presets/order.txt, then by name. Defined by cmake/preset_embed.cmake.
std::span<const PresetText> preset_texts();

}  // namespace terrella
