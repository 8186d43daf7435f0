// Settings with names, chosen from a front.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "measure/front.hpp"

namespace terrella {

struct QualityPreset {
  std::string name;         // "fast", "balanced", "high" or "reference"
  std::size_t setting = 0;  // by number in the offers
  double target = 0.0;      // dB that it is to reach; of "reference" 0: it is the finest there is
  bool reached = false;
};

// From the cheapest to the finest, which is "reference". "fast", "balanced" and "high" are the cheapest that reach 28,
// 34 and 40 dB. Each takes at most 1/1.6 of the time of the next, or it is dropped. Where none on the front reaches a
// target, it is the most accurate for which there is room between those that reach theirs and the next.
// front: as front_of gives it.
std::vector<QualityPreset> quality_presets(const std::vector<Offer>& offers, const std::vector<std::size_t>& front);

}  // namespace terrella
