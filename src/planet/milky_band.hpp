// The band of far stars across the sky: dim points, and glow of those too many to be told apart.
#pragma once

#include <vector>

#include "planet/stars.hpp"

namespace terrella {

// Glows first, then points. None where stars.band is 0.
StarSky find_milky_band(const Scene& scene);

// Normal (unit) of the plane that it lies around.
glm::vec3 milky_band_normal(const Scene& scene);

}  // namespace terrella
