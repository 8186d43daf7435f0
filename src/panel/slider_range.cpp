#include "panel/slider_range.hpp"

#include <algorithm>
#include <cmath>

namespace terrella {
namespace {

// What a logarithmic slider spans where its parameter may be 0. Lengths and speeds need more of it: from a ripple to a
// continent.
constexpr double decades = 4.0, decades_of_lengths = 7.0;

constexpr double small_step = 0.01;  // of the slider

// The fineness of a linear slider: some more steps than it has pixels.
constexpr double least_steps = 300.0;
constexpr int significant_digits = 3;

int decade_of(double value) { return static_cast<int>(std::floor(std::log10(value))); }

// To a multiple of a power of ten, as the double nearest to that decimal.
double rounded(double value, int exponent) {
  const double power = std::pow(10.0, std::abs(exponent));
  return exponent < 0 ? std::round(value * power) / power : std::round(value / power) * power;
}

}  // namespace

double SliderRange::value_at(double position) const {
  if (!(position > 0.0)) return low;
  if (position >= 1.0) return high;
  double value = 0.0;
  if (first > 0.0) {
    value = first * std::pow(high / first, position);
    value = rounded(value, decade_of(value) - (significant_digits - 1));
  } else {
    value = low + position * (high - low);
    value = rounded(value, decade_of((high - low) / least_steps));
  }
  return std::clamp(whole ? std::round(value) : value, low, high);
}

double SliderRange::position_of(double value) const {
  if (!(value > low)) return 0.0;
  if (value >= high) return 1.0;
  if (first == 0.0) return (value - low) / (high - low);
  return value > first ? std::log(value / first) / std::log(high / first) : 0.0;
}

double SliderRange::stepped(double value, double steps) const {
  if (steps == 0.0) return value;
  const double from = position_of(value);
  for (double step = small_step * steps; std::abs(step) <= 1.0; step *= 1.5) {
    const double next = value_at(from + step);
    if (steps > 0.0 ? next > value : next < value) return next;
  }
  return steps > 0.0 ? std::max(value, high) : std::min(value, low);
}

SliderRange slider_range(const Parameter& parameter, const Scene& scene) {
  SliderRange range{parameter.min, parameter.max, 0.0, parameter.type == Type::Int};
  // At most a radius a second, but for winds, which are what they are on any planet.
  const bool speed = parameter.unit == "m/s" && parameter.scale == Scale::Logarithmic;
  if (parameter.is_length()) range.high = std::min(parameter.max, parameter.slider_max * scene.planet.radius);
  if (speed) range.high = std::min(parameter.max, scene.planet.radius);
  if (parameter.scale == Scale::Logarithmic) {
    const double span = std::pow(10.0, parameter.is_length() || speed ? decades_of_lengths : decades);
    range.first = range.low > 0.0 ? range.low : range.high / span;
  }
  return range;
}

}  // namespace terrella
