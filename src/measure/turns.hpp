// Scenes timed by turns, so that what slows the machine for a while slows all of them.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "measure/cameras.hpp"
#include "measure/trade.hpp"
#include "measure/truth.hpp"

namespace terrella {

// A scene, and which other one is timed next to it each time, to tell by how much they differ.
struct Timed {
  Scene scene;
  std::optional<std::size_t> beside;
};

struct Turns {
  std::vector<std::vector<Sighting>> sightings;  // of each scene by each camera
  std::vector<double> control_ms;
  bool gpu_timer = false;
};

// Each scene has a renderer of its own. truths: by camera.
Turns take_turns(const std::vector<Timed>& scenes, const std::vector<Viewpoint>& cameras, std::vector<Truth>& truths,
                 const TradePlan& plan, const std::function<void(double part)>& progress);

}  // namespace terrella
