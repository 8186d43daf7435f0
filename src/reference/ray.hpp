// Rays in double precision. Lengths in planet radii; the planet's centre is the origin.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "formulas/formulas.hpp"

namespace terrella::reference {

struct Ray {
  glm::dvec3 origin;
  glm::dvec3 direction;  // unit

  [[nodiscard]] glm::dvec3 at(double t) const { return origin + t * direction; }
};

// A piece of a ray.
struct Span {
  double from, to;
};

// How short pieces of a ray are looked at.
struct Resolution {
  double per_distance;  // of their distance along the ray
  double least;         // length, > 0
};

// Where a ray lies within a sphere around the centre, before and behind its origin; nothing where it passes the sphere.
inline std::optional<Span> within_sphere(const Ray& ray, double radius) {
  const f64::Roots roots = f64::ray_sphere(ray.origin, ray.direction, radius);
  return roots.t1 > roots.t0 ? std::optional(Span{roots.t0, roots.t1}) : std::nullopt;
}

// Where a ray enters a sphere that its origin is outside of, or leaves one that it is inside of; only ahead.
inline std::optional<double> meets_sphere(const Ray& ray, double radius) {
  const std::optional<Span> inside = within_sphere(ray, radius);
  if (!inside) return std::nullopt;
  const double t = glm::length(ray.origin) > radius ? inside->from : inside->to;
  return t > 0.0 ? std::optional(t) : std::nullopt;
}

}  // namespace terrella::reference
