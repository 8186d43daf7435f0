// One case, drawn by the real renderer and looked at.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "measure/cases.hpp"
#include "measure/checks.hpp"
#include "render/renderer.hpp"

namespace terrella {

struct Findings {
  std::int64_t nonfinite = 0;          // pixels of light
  Holes holes;                         // in the distances
  std::int64_t lying = 0;              // pixels whose normal is not of unit length, nor 0 as the sky's
  bool repeats = true;                 // the same scene drawn again gives the same light, bit for bit
  unsigned gl_error = 0;               // 0: none
  std::vector<std::string> over_cost;  // sentences
  double milliseconds = 0.0;           // for all of it

  [[nodiscard]] bool clean() const;
  // What is wrong, in words; empty where nothing is.
  [[nodiscard]] std::string text() const;
};

// Needs a context that can draw to 32 bit floats: without them distances and light are rounded too coarsely to judge.
Findings examine(Renderer& renderer, const Case& entry);

}  // namespace terrella
