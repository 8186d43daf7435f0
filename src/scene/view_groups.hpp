#pragma once

#include <string_view>

#include "scene/scene.hpp"

namespace terrella {

// Whether a group tells how a planet is looked at, not what it is: camera, picture, time, quality.
bool is_of_view(std::string_view group);

// A scene looked at as another is: with its camera, as high in radii, its picture, time and quality.
Scene seen_as(Scene scene, const Scene& seen);

}  // namespace terrella
