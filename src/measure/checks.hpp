// What is looked for in every picture, whatever it shows.
#pragma once

#include <cstdint>
#include <span>

#include "planet/pose.hpp"

namespace terrella {

// Pixels as the renderer gives them: four floats each, bottom row first.
using Pixels = std::span<const float>;

// Pixels of which a channel is infinite or no number.
std::int64_t nonfinite_pixels(Pixels light);

struct Holes {
  std::int64_t looked_at = 0;  // pixels that the sphere surely covers
  std::int64_t open = 0;       // of those, the ones that show what lies behind where it begins, or nothing
};

// Looks for pixels through which one sees into or past the planet. distance: the channel of that name, planet radii,
// +Inf for the sky; solid: radius (planet radii) of a sphere that ground or water hides whole, 0: there is none. Pixels
// within a hundredth of a pixel of the sphere's edge are left out.
Holes find_holes(Pixels distance, const Pose& pose, const View& view, double solid);

}  // namespace terrella
