// Settings tried for the walk from the cheapest to the finest: one renderer, a few frames.
#pragma once

#include <functional>
#include <vector>

#include "measure/trade.hpp"
#include "measure/truth.hpp"

namespace terrella {

// Walks up the knobs of a scene and tells of all settings that were tried, in that order: the first is the cheapest of
// all knobs, the last the finest. truths: by camera. scenes: gets the scene of each.
std::vector<Estimate> try_settings(const Scene& scene, const std::vector<KnobTrade>& knobs,
                                   const std::vector<Viewpoint>& cameras, const std::vector<Truth>& truths,
                                   const TradePlan& plan, const std::function<void(double part)>& progress,
                                   std::vector<Scene>& scenes);

}  // namespace terrella
