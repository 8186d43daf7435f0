// The moment at which pictures are judged.
#pragma once

#include "scene/scene.hpp"

namespace terrella {

// Seconds. A third of the longest time between two pictures of the clouds that are blended (Needs::cloud_interval): as
// the others are halves of it, halves of these and so on, it lies at a third or two thirds of every one of them, and
// what blending loses there says how often each setting renews its clouds. 0 for clouds that need a day for that or
// never change.
double judged_at(const Scene& scene);

}  // namespace terrella
