// The flow noise of a scene's clouds.
#pragma once

#include <array>

#include "formulas/formulas.hpp"
#include "scene/scene.hpp"

namespace terrella {

// Cosine and sine of the angle by which the gradients of a layer are turned: those of layer i 2^i times as fast as the
// coarsest (Sandahl 18). seconds: any.
glm::dvec2 turn_of_cloud_layer(const Scene& scene, int layer, double seconds);

// xyz: eye (unit); w: radius.
struct Cyclones {
  std::array<glm::dvec4, f64::cyclone_count> places;
  int count = 0;
};

Cyclones cyclones_of(const Scene& scene);

}  // namespace terrella
