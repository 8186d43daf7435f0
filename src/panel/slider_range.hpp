// How far a parameter's slider goes, and which value lies where on it.
#pragma once

#include "scene/parameters.hpp"

namespace terrella {

struct SliderRange {
  double low = 0.0, high = 1.0;
  // The smallest value that a logarithmic slider tells from `low`; 0 on a linear one.
  double first = 0.0;
  bool whole = false;

  // The value at a position 0..1, rounded to what a hand can mean: 0.85 rather than 0.84973.
  double value_at(double position) const;
  // The nearest position, 0..1, of any value.
  double position_of(double value) const;
  // The value some small steps further, at least to the next that the slider tells apart. steps may be parts of one,
  // and below 0.
  double stepped(double value, double steps) const;
};

// Of a Float or Int. The sliders of lengths and speeds go as far as makes sense on the scene's planet.
SliderRange slider_range(const Parameter& parameter, const Scene& scene);

}  // namespace terrella
