// All that is measured at the extremes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "measure/examine.hpp"
#include "measure/invariances.hpp"
#include "measure/limits.hpp"

namespace terrella {

// Cases of one group, drawn in one kind of context.
struct GroupTally {
  std::string api, group;  // "core" or "es"; as in Case
  int cases = 0, faulty = 0;
  std::int64_t hidden = 0;  // pixels that were looked at for holes
  int compared = 0;         // of the cases, with the reference
  double off = 0.0;         // the worst of how far light was off there
  double milliseconds = 0.0;
};

struct Fault {
  std::string api, group, name;
  std::string link;  // of the scene
  int width = 0, height = 0;
  double seconds = 0.0;
  std::string text;  // what is wrong
};

struct ExtremesReport {
  std::string renderer;
  Extent extent = Extent::quick;
  double seconds = 0.0;  // that all of it took
  std::vector<GroupTally> groups;
  std::vector<Fault> faults;
  std::vector<Limit> limits;
  std::vector<Invariance> invariances;

  // No fault, no limit without its word, no broken invariance.
  [[nodiscard]] bool holds() const;
};

// Is told after each case which part of them is done, 0..1.
using Progress = std::function<void(double part)>;

// Draws the cases with a renderer of the context that is current, and adds what was found.
void examine_all(Renderer& renderer, const std::string& api, Extent extent, const Progress& progress,
                 ExtremesReport& report);

}  // namespace terrella
