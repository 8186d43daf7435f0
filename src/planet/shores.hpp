// What waves feel of a scene's ground.
#pragma once

#include "planet/waves.hpp"
#include "scene/scene.hpp"

namespace terrella {

// How steep the ground usually is where land begins: the median of slopes at shores all over the planet, at least
// 0.005; 0.05 where there are none. footprint (rad): of what is left out of the ground.
double shore_slope(const Scene& scene, double footprint);

// Depth (planet radii) from which less than a thousandth of the bottom's light comes up, and waves feel next to nothing
// of it.
double hiding_depth(const Scene& scene, const Sea& sea);

// The ground as the waves of a sea feel it, but for a place's own depth and slope, which are 0. The usual slope is that
// of the ground without what is finer than the longest wave.
f64::Shore shore_of(const Scene& scene, const Sea& sea);

// Height over the still water (planet radii) up to which waves keep the ground wet; 0 where they don't run up.
double wet_height(const Scene& scene, const Sea& sea);

// The first of two layers of the ground's noise that tear the foam of surf: as small as the waves are high. -1 where
// the scene has none.
int foam_layer(const Scene& scene, const Sea& sea);

}  // namespace terrella
