// A picture of the renderer beside the reference, at a few places of it: enough to see that it shows the same scene.
#pragma once

#include "measure/checks.hpp"
#include "scene/scene.hpp"

namespace terrella {

struct BesideReference {
  double light = 0.0;       // mean over the places of how far light, held to 0..1, is off in its worst channel
  double brightness = 0.0;  // mean over the places of the reference's light, held to 0..1, in its brightest channel
  double silhouette = 0.0;  // part of the places where only one of both shows the planet

  // The bounds stand a little beside what was measured at the extremes: 0.22 of the brightness and 2 of 48 places. A
  // black picture is off by all of the brightness, a mirrored one by a third or more, one of another seed by about 0.4.
  [[nodiscard]] bool same_light() const { return light <= 0.02 + 0.25 * brightness; }
  [[nodiscard]] bool same_silhouette() const { return silhouette <= 0.05; }
};

// Meshes and maps so fine that what they leave out does not count as a difference.
void make_comparable(Scene& scene);

// light, distance: as the renderer gives them, in 32 bit floats.
BesideReference beside_reference(const Scene& scene, const View& view, Pixels light, Pixels distance);

}  // namespace terrella
