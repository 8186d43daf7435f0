// How large and how fast people are on a planet. On planets of less than a kilometre's radius they are as much smaller
// as the planet is, at the same pace of time: eyes are 1.7 thousandths of a radius over the ground, and a fall, a jump
// and a walk over a hill take as long as on a planet of a kilometre. On larger ones they are as large as we are.
#pragma once

#include <algorithm>

#include "app/camera_frame.hpp"

namespace terrella {

// Planet radii that a metre of theirs is.
inline double human_metre(const Scene& scene) { return 1.0 / std::max(scene.planet.radius, 1000.0); }

// Of standing eyes over their feet, planet radii.
inline double eye_height(const Scene& scene) { return std::max(1.7 * human_metre(scene), least_clearance(scene)); }

}  // namespace terrella
