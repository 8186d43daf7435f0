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
  double bound = 0.0;     // measured must be at most this much
  double at_stake = 0.0;  // how much there was that could have differed: the contrast of a picture, or how far what
                          // moves in it moved. Nothing can be told from two empty pictures, or two still ones.

  [[nodiscard]] bool tells() const { return at_stake > 1e-6; }
  [[nodiscard]] bool holds() const { return tells() && measured <= bound; }
};

// How alike in size the changes from frame to frame are, at the beginning and after 1e9 s: the larger one, as a
// multiple of the other.
Invariance moves_alike(Renderer& renderer, const std::string& name, const Scene& scene, Channel channel, double bound);

std::vector<Invariance> measure_invariances(Renderer& renderer, Extent extent);

}  // namespace terrella
