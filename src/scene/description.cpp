#include "scene/description.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/check.hpp"
#include "base/text.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

std::string degrees(double angle, std::string_view positive, std::string_view negative) {
  const double whole = std::round(std::abs(angle));
  if (whole == 0.0) return "0 degrees";
  return text_of(whole, whole == 1.0 ? " degree " : " degrees ", angle > 0.0 ? positive : negative);
}

// Where the camera stands and how well it is drawn is no change of the planet.
bool of_the_planet(const Parameter& parameter) { return parameter.group != "camera" && parameter.group != "quality"; }

}  // namespace

std::string description(const SceneDocument& document) {
  const Preset* preset = find_preset(document.preset);
  CHECK(preset != nullptr, document.preset);
  const auto all = parameters();
  const auto changed = std::count_if(all.begin(), all.end(), [&](const Parameter& parameter) {
    return of_the_planet(parameter) && parameter.get(document.scene) != parameter.get(preset->scene);
  });
  const auto& camera = document.scene.camera;
  std::string text =
      text_of(preset->title, ", a procedural planet. ", preset->about, ". Seen from above ",
              degrees(camera.latitude, "north", "south"), ", ", degrees(camera.longitude, "east", "west"), '.');
  if (changed > 0) text += text_of(' ', changed, changed == 1 ? " setting" : " settings", " changed.");
  return text;
}

}  // namespace terrella
