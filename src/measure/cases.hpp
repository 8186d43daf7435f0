// Scenes and views at the ends of what can be asked for.
#pragma once

#include <string>
#include <vector>

#include "planet/pose.hpp"
#include "scene/scene.hpp"

namespace terrella {

struct Case {
  std::string group;  // "single", "pair", "random", "view", "preset"
  std::string name;   // "waves.length = 1e-06"; unique within its group
  Scene scene;
  View view;  // width, height and seconds; the rest as by default
};

// How much of the extremes is driven to.
enum class Extent {
  sample,  // a few of each group, for tests under sanitizers
  quick,   // all that small pictures and coarse maps can show
  full,    // large pictures and fine maps as well
};

// Every parameter at its ends, one at a time; every two ends of two parameters (all-pairs); random ends and values of
// all of them; radii, altitudes, places, times, fields of view and sizes of pictures; every preset. Deterministic.
std::vector<Case> extreme_cases(Extent extent);

// Maps and meshes as coarse as they can be, so that a case takes milliseconds.
void make_cheap(Scene& scene);

}  // namespace terrella
