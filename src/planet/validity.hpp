// Where the techniques of this version hold, as measured (src/measure/limits.cpp), and what of a scene lies beyond.
#pragma once

#include <vector>

#include "base/issues.hpp"
#include "planet/needs.hpp"
#include "planet/pose.hpp"
#include "scene/scene.hpp"

namespace terrella {

// A sentence for each parameter that takes a technique out of the range in which it holds, with the value and the
// range. Only of what is modelled, and where it could be seen. pose, needs: those of scene and view.
std::vector<Issue> beyond_validity(const Scene& scene, const View& view, const Pose& pose, const Needs& needs);

}  // namespace terrella
