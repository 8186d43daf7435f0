// The ways of drawing a ground of nodes, which are measured beside each other.
#pragma once

#include <span>

#include "planet/needs.hpp"

namespace terrella {

// Those that this build has; each is a choice of terrain.model by its name.
std::span<const Ground> ground_models();

// The scene with its ground drawn that way.
Scene with_ground(Scene scene, Ground model);

}  // namespace terrella
