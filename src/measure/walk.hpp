// From the cheapest setting of several knobs to the finest, each time by the step that buys most.
#pragma once

#include <functional>
#include <vector>

#include "measure/front.hpp"

namespace terrella {

// Which of its values each knob is at, from 0.
using Levels = std::vector<int>;

// The settings on the way, from all knobs at 0 to all at their last value. counts: of the values of each knob, 1 or
// more. measure: what a setting asks and gives; called for settings beside the way as well. Not every step is tried
// everywhere: two that promised most when they were last tried, and the one whose trial is longest ago, so that a knob
// which has become worth raising is found.
std::vector<Levels> walk_up(const std::vector<int>& counts, const std::function<Offer(const Levels&)>& measure);

}  // namespace terrella
