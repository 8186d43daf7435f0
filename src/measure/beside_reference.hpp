// A picture of the renderer beside the reference, at a few places of it: enough to see that it shows the same scene.
#pragma once

#include "measure/checks.hpp"
#include "scene/scene.hpp"

namespace terrella {

struct BesideReference {
  double light = 0.0;       // mean over the places of how far light, held to 0..1, is off in its worst channel
  double brightness = 0.0;  // mean over the places of the reference's light, held to 0..1, in its brightest channel
  double silhouette = 0.0;  // part of the places where only one of both shows the planet
};

// light, distance: as the renderer gives them, in 32 bit floats.
BesideReference beside_reference(const Scene& scene, const View& view, Pixels light, Pixels distance);

}  // namespace terrella
