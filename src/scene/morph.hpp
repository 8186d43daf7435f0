#pragma once

#include "scene/scene.hpp"

namespace terrella {

// A scene between two others; share: 0 gives `from`, 1 gives `to`, exactly. Numbers run as their sliders do, lengths
// and speeds as parts of the radius, so that nothing outgrows the planet on the way. Colours mix as light does.
// Choices, switches and seeds, which have no between, change at the half. Each value lies between those at the ends.
Scene morph(const Scene& from, const Scene& to, double share);

}  // namespace terrella
