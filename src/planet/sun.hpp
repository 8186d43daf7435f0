// The sun as a picture shows it. It stands at infinity.
#pragma once

#include "planet/pose.hpp"

namespace terrella {

// Tangent of the sun's apparent radius, as it is drawn: of any size at least a point's.
double seen_sun_radius(const Scene& scene);

// Size of a pixel where the sun stands, rad. In wide pictures those away from the middle are much smaller than that in
// it.
double pixel_at_sun(const Scene& scene, const Pose& pose);

// Part of the sun's disc that the solid planet leaves free, 0..1: 1 in front of it and beside it. solid: radius of what
// hides it, planet radii, 0: nothing does.
double free_part_of_sun(const Scene& scene, const Pose& pose, double solid);

// Whether the disc, or also its glare, reaches into the picture.
bool sun_in_picture(const Scene& scene, const View& view, const Pose& pose, bool with_glare);

}  // namespace terrella
