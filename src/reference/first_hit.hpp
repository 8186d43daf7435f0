// Where a ray first meets a surface that has one radius in each direction from the planet's centre.
#pragma once

#include "reference/directions.hpp"
#include "reference/ray.hpp"

namespace terrella::reference {

// The side of a surface that a ray begins on.
enum class Side { above, below };

// Surface:
//   double radius_at(direction)                 exact; direction: unit
//   bool reaches(direction, radius)             whether it is at least radius there
//   bool stays_below(directions, radius)        true only if all of the surface lies below radius in all Directions
//   bool stays_above(directions, radius)        the same above it; asked for from below alone
//
// Halves the span until no piece is left that the surface might reach, or a piece is as short as the resolution: so a
// crest is missed only if the ray cuts less than that out of it. Then brackets the crossing. At `from` the ray is on
// its side of the surface. Returns the distance along the ray, within 1e-13 of it, or nothing.
template <Side side = Side::above, class Surface>
std::optional<double> first_hit(const Surface& surface, const Ray& ray, const Span& span,
                                const Resolution& resolution) {
  const double nearest = -glm::dot(ray.origin, ray.direction);
  const auto height_over = [&](double t) {
    const glm::dvec3 place = ray.at(t);
    const double radius = glm::length(place);
    const double over = radius - surface.radius_at(place / radius);
    return side == Side::above ? over : -over;
  };
  const auto past_surface = [&](double t) {
    const glm::dvec3 place = ray.at(t);
    const double radius = glm::length(place);
    return surface.reaches(place / radius, radius) == (side == Side::above);
  };
  // Nothing where the ray points at the centre or away from it: rounding would turn it.
  const auto along = [&](const glm::dvec3& direction) -> std::optional<glm::dvec3> {
    const glm::dvec3 aside = ray.direction - glm::dot(ray.direction, direction) * direction;
    const double length = glm::length(aside);
    return length > 1e-6 ? std::optional(aside / length) : std::nullopt;
  };
  const auto clear = [&](double from, double to) {
    const glm::dvec3 middle = glm::normalize(ray.at(0.5 * (from + to)));
    const double chord = std::max(glm::distance(glm::normalize(ray.at(from)), middle),
                                  glm::distance(glm::normalize(ray.at(to)), middle));
    const Directions directions{middle, chord, along(middle)};
    if constexpr (side == Side::below) {
      return surface.stays_above(directions, std::max(glm::length(ray.at(from)), glm::length(ray.at(to))));
    } else {
      return surface.stays_below(directions, glm::length(ray.at(std::clamp(nearest, from, to))));
    }
  };
  // False position, where an end that stays counts half (the Illinois method): it never leaves the bracket.
  const auto crossing = [&](double above, double below) {
    double height_above = height_over(above), height_below = height_over(below);
    int stays = 0;
    for (int i = 0; i < 200 && below - above > 1e-13 * below; ++i) {
      const double share = height_above / (height_above - height_below);
      const double guess = above + (share > 0.0 && share < 1.0 ? share : 0.5) * (below - above);
      const double height = height_over(guess);
      if (height > 0.0) {
        above = guess;
        height_above = height;
        if (stays > 0) height_below *= 0.5;
        stays = 1;
      } else {
        below = guess;
        height_below = height;
        if (stays < 0) height_above *= 0.5;
        stays = -1;
      }
      if (std::abs(height) < 1e-15) return guess;
    }
    return below;
  };
  // The nearest half first.
  const auto search = [&](const auto& self, double from, double to) -> std::optional<double> {
    if (clear(from, to)) return std::nullopt;
    if (to - from < std::max(resolution.per_distance * from, resolution.least))
      return past_surface(to) ? std::optional(crossing(from, to)) : std::nullopt;
    const double middle = 0.5 * (from + to);
    const auto found = self(self, from, middle);
    return found ? found : self(self, middle, to);
  };
  return span.to > span.from ? search(search, span.from, span.to) : std::nullopt;
}

}  // namespace terrella::reference
