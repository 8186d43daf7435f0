#pragma once

#include <string>
#include <string_view>

#include "scene/scene.hpp"

namespace terrella {

// The preset that is the default scene.
inline constexpr std::string_view kDefaultPreset = "temperate";

// A scene and the preset that it started from. What is saved and shared is the difference between the two, so that a
// text says no more than what its author changed.
struct SceneDocument {
  Scene scene;
  std::string preset{kDefaultPreset};  // always the name of a preset

  bool operator==(const SceneDocument&) const = default;
};

}  // namespace terrella
