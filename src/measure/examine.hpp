// One case, drawn by the real renderer and looked at.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "measure/beside_reference.hpp"
#include "measure/cases.hpp"
#include "measure/checks.hpp"
#include "render/renderer.hpp"

namespace terrella {

struct Findings {
  std::int64_t nonfinite = 0;                // pixels of light
  Holes holes;                               // in the distances
  std::int64_t lying = 0;                    // pixels whose normal is not of unit length, nor 0 as the sky's
  bool repeats = true;                       // the same scene drawn again gives the same light, bit for bit
  unsigned gl_error = 0;                     // 0: none
  std::vector<std::string> over_cost;        // sentences
  std::optional<BesideReference> reference;  // where it was asked for and can be judged
  double milliseconds = 0.0;                 // for all of it

  [[nodiscard]] bool clean() const;
  // What is wrong, in words; empty where nothing is.
  [[nodiscard]] std::string text() const;
};

// Which of the cases, by number, are compared with the reference: some of every group.
inline bool compared_with_reference(std::size_t number) { return number % 7 == 0; }

// Needs a context that can draw to 32 bit floats: without them distances and light are rounded too coarsely to judge.
// beside: draws it once more, as finely as need be, and compares it with the reference, unless the picture is of a few
// pixels or beyond the range in which techniques hold.
Findings examine(Renderer& renderer, const Case& entry, bool beside);

}  // namespace terrella
