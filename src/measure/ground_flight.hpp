// What the CPU does for a ground of real size in the frames of a flight from orbit to where one stands.
#pragma once

#include <string>
#include <vector>

#include "planet/needs.hpp"
#include "scene/document.hpp"

namespace terrella {

// Of one frame: where it is, how near its ground is, which nodes are drawn, and those made that it has time for.
struct FlightFrame {
  double clearance = 0.0;  // m
  double ms = 0.0;
  bool complete = false;  // no node is missing that the picture asks for, and no grid gives way to another
};

struct FlightPlan {
  int width = 1920, height = 1080;  // pixels of the pictures, which are not drawn
  int frames = 600;                 // > 0
};

// The frames of a flight from 10,000 km over another place to 10 m over that of seen_from. Flown three times with all
// nodes made anew; times are the least of each frame, for whatever else the machine does. model: of nodes. Needs a
// current context.
std::vector<FlightFrame> fly_to_ground(const SceneDocument& document, Ground model, const FlightPlan& plan);

struct FlightRow {
  std::string scene, model;
  double median_ms = 0.0, p90_ms = 0.0, worst_ms = 0.0;
  double worst_at = 0.0;    // m over the ground
  double longer = 0.0;      // part of the frames that take longer than twice the median
  double incomplete = 0.0;  // part of the frames
};

// frames: at least one.
FlightRow flight_row(const std::string& scene, Ground model, const std::vector<FlightFrame>& frames);

}  // namespace terrella
