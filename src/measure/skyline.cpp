#include "measure/skyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "formulas/formulas.hpp"

namespace terrella {
namespace {

constexpr int columns = 4096;

}  // namespace

GroundSkyline::GroundSkyline(const glm::dvec3& eye)
    : eye_(eye),
      up_(glm::normalize(eye)),
      along_(f64::perpendicular(up_)),
      across_(glm::cross(up_, along_)),
      highest_(columns, -std::numeric_limits<double>::infinity()) {}

GroundSkyline::Sight GroundSkyline::sight_of(const glm::dvec3& place) const {
  const glm::dvec3 from_eye = place - eye_;
  const double x = glm::dot(from_eye, along_), y = glm::dot(from_eye, across_);
  const double turn = 0.5 + 0.5 * std::atan2(y, x) / std::numbers::pi;
  return {turn * columns, glm::dot(from_eye, up_) / std::max(std::hypot(x, y), 1e-300)};
}

bool GroundSkyline::hides(const glm::dvec3& place) const {
  const Sight sight = sight_of(place);
  const int column = std::clamp(static_cast<int>(sight.column), 0, columns - 1);
  return sight.elevation < highest_[static_cast<std::size_t>(column)];
}

void GroundSkyline::add(const std::vector<glm::dvec3>& vertices, const std::vector<std::uint16_t>& triangles) {
  std::vector<Sight> sights;
  for (const glm::dvec3& vertex : vertices) sights.push_back(sight_of(vertex));
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) add_edge(sights[triangles[i + k]], sights[triangles[i + (k + 1) % 3]]);
  }
}

void GroundSkyline::add_edge(Sight a, Sight b) {
  if (a.column > b.column) std::swap(a, b);
  if (b.column - a.column > 0.5 * columns) return;  // across where columns begin
  // In the middles of columns.
  for (int column = static_cast<int>(std::ceil(a.column - 0.5)); column + 0.5 <= b.column; ++column) {
    const double part = (column + 0.5 - a.column) / std::max(b.column - a.column, 1e-12);
    double& highest = highest_[static_cast<std::size_t>(std::clamp(column, 0, columns - 1))];
    highest = std::max(highest, a.elevation + part * (b.elevation - a.elevation));
  }
}

}  // namespace terrella
