// Bounds between which a value lies.
#pragma once

#include <algorithm>

namespace terrella::reference {

struct Range {
  double least, most;

  [[nodiscard]] bool lies_apart_from(const Range& other) const { return most < other.least || least > other.most; }
  [[nodiscard]] bool lies_apart_from(double value) const { return lies_apart_from({value, value}); }
  // Of the greater of two values.
  [[nodiscard]] Range under(const Range& other) const {
    return {std::max(least, other.least), std::max(most, other.most)};
  }
};

}  // namespace terrella::reference
