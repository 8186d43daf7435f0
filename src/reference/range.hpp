// Bounds between which a value lies.
#pragma once

namespace terrella::reference {

struct Range {
  double least, most;

  // Whether the value is known to be smaller or larger.
  [[nodiscard]] bool tells_from(double value) const { return most < value || least > value; }
};

}  // namespace terrella::reference
