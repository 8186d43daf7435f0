// Radii of the spheres that a scene's parts lie on, planet radii.
#pragma once

#include "scene/scene.hpp"

namespace terrella {

// Of the still sea.
inline double water_radius(const Scene& scene) { return 1.0 + scene.water.level / scene.planet.radius; }

// Of the layer of clouds.
inline double cloud_radius(const Scene& scene) { return 1.0 + scene.clouds.height / scene.planet.radius; }

// At which the air ends.
inline double air_radius(const Scene& scene) { return 1.0 + scene.air.height / scene.planet.radius; }

}  // namespace terrella
