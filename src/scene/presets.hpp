#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/issues.hpp"
#include "scene/scene.hpp"

namespace terrella {

// A scene that comes with the program: a file of the folder presets, built in.
struct Preset {
  std::string name;   // the file's, "storm"
  std::string title;  // a few words, "Storm at sea"
  std::string about;  // one sentence, without its full stop
  Scene scene;
};

// All presets; the default one first, the others in the order of preset_texts().
std::span<const Preset> presets();

// Null if there is none of this name.
const Preset* find_preset(std::string_view name);

// "preset: there is no preset "strom"; did you mean storm?"
Issue no_such_preset(std::string_view name);

}  // namespace terrella
