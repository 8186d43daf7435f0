// What must not change a picture, or not by more than a bound.
#pragma once

#include <string>
#include <vector>

#include "measure/cases.hpp"
#include "render/renderer.hpp"

namespace terrella {

struct Invariance {
  std::string what;   // "all lengths times 2^20"
  std::string error;  // what the measured number is
  double measured = 0.0;
  double bound = 0.0;  // measured must be at most this much
  [[nodiscard]] bool holds() const { return measured <= bound; }
};

std::vector<Invariance> measure_invariances(Renderer& renderer, Extent extent);

}  // namespace terrella
