#pragma once

#include <string>
#include <vector>

#include "measure/ground_table.hpp"
#include "native/egl_context.hpp"

namespace terrella {

struct GroundTask {
  std::vector<SceneDocument> documents;
  GroundPlan plan;
  Api api = Api::core;
  std::string folder;
};

// `terrella measure --ground`: measures, writes and tells; returns what went wrong or which limits are broken, or
// nothing.
std::string measure_ground(const GroundTask& task);

}  // namespace terrella
