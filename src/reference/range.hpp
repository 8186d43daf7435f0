// Bounds between which a value lies.
#pragma once

namespace terrella::reference {

struct Range {
  double least, most;

  [[nodiscard]] bool lies_apart_from(const Range& other) const { return most < other.least || least > other.most; }
  [[nodiscard]] bool lies_apart_from(double value) const { return lies_apart_from({value, value}); }
};

}  // namespace terrella::reference
