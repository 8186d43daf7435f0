// Scenes timed by turns, so that what slows the machine for a while slows all of them.
#pragma once

#include <functional>
#include <vector>

#include "measure/cameras.hpp"
#include "measure/trade.hpp"
#include "measure/truth.hpp"

namespace terrella {

struct Turns {
  std::vector<std::vector<Sighting>> sightings;  // of each scene by each camera
  std::vector<double> control_ms;
  bool gpu_timer = false;
};

// Each scene has a renderer of its own. truths: by camera.
Turns take_turns(const std::vector<Scene>& scenes, const std::vector<Camera>& cameras, std::vector<Truth>& truths,
                 const TradePlan& plan, const std::function<void(double part)>& progress);

}  // namespace terrella
