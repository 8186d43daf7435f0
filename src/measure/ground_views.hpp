// From where a ground of real size is looked at to be measured.
#pragma once

#include <span>

#include "scene/document.hpp"

namespace terrella {

// Over the ground or sea below, m, from the lowest.
std::span<const double> measured_altitudes();

// The scene from so high over a place on land (for a scene of no preset that has one, over its own camera's), 60
// degrees high: low with the horizon over the middle of the picture, from far away straight down.
Scene seen_from(const SceneDocument& document, double altitude);

}  // namespace terrella
