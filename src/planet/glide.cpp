#include "planet/glide.hpp"

#include <cmath>

namespace terrella {

Glide::Glide(double distance, double from_height, double to_height) {
  const double wide = curvature * curvature * distance;
  there_ = arc(wide, from_height, to_height);
  back_ = arc(wide, to_height, from_height);
  // By the half of the angle: as the print has it, nothing is left of it where both ends are close.
  const double chord = std::hypot(wide, to_height - from_height);
  angle_ = 2.0 * std::asinh(0.5 * chord / (std::sqrt(from_height) * std::sqrt(to_height)));
}

// The print's b0 is a / b, and r0 the number whose hyperbolic sine is -b0. Only hyperbolic tangent and secant of that
// are needed: they stay finite where there is no distance.
Glide::Arc Glide::arc(double distance, double from_height, double to_height) {
  const double a = (to_height - from_height) * (to_height + from_height) + distance * distance;
  const double b = 2.0 * from_height * distance, size = std::hypot(a, b);
  if (size == 0.0) return {from_height, 1.0, 0.5, 0.5};
  const double most = 0.5 * (1.0 + std::abs(a) / size), least = 0.5 * (b / size) * (b / (size + std::abs(a)));
  return {from_height, b / size, a > 0.0 ? most : least, a > 0.0 ? least : most};
}

// The print's w0 cosh r0 / cosh(r0 + angle), and the distance there, both divided by cosh r0: only terms above 0 are
// added, so that no digits are lost however long the way is.
Glide::Point Glide::walk(const Arc& arc, double angle) {
  const double divisor = arc.down * std::exp(angle) + arc.up * std::exp(-angle);
  return {arc.height * arc.level * std::sinh(angle) / divisor / (curvature * curvature), arc.height / divisor};
}

Glide::Point Glide::from_end(double part) const {
  const Point back = walk(back_, angle_ * (1.0 - part));
  return {-back.along, back.height};
}

}  // namespace terrella
