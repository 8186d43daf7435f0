// Where each technique holds: its error along one parameter, and whether the program says that the range was left.
#pragma once

#include <string>
#include <vector>

#include "measure/cases.hpp"
#include "render/renderer.hpp"

namespace terrella {

struct LimitPoint {
  double value = 0.0;   // of the parameter
  double error = 0.0;   // infinite where a pixel lost its surface
  bool warned = false;  // beyond_validity has a sentence about the parameter
};

struct Limit {
  std::string technique;  // "ripples"
  std::string path;       // of the parameter that is varied: "camera.altitude"
  std::string unit;       // of its values: "m, planet of 1 m"
  std::string error;      // what the error is, with its unit
  double demand = 0.0;    // the error that is allowed wherever nothing is said
  std::vector<LimitPoint> points;

  // No error above the demand goes unsaid.
  [[nodiscard]] bool keeps_its_word() const;
  // The worst error where nothing is said. Infinite where something is said of every point: then no range is known in
  // which the technique holds.
  [[nodiscard]] double worst_within() const;
  // Whether something was said, and with reason: an error above the demand was found there.
  [[nodiscard]] bool ends() const;
};

// Each draws small pictures; all of them take some seconds on two cores without a GPU.
std::vector<Limit> measure_limits(Renderer& renderer, Extent extent);

// Of these: what meshes and maps are too coarse for, what jitters under a moving camera, and how evenly time runs.
std::vector<Limit> limits_of_detail(Renderer& renderer, Extent extent);
std::vector<Limit> limits_of_stillness(Renderer& renderer, Extent extent);
std::vector<Limit> limits_of_time(Renderer& renderer, Extent extent);

}  // namespace terrella
