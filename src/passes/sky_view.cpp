#include "passes/sky_view.hpp"

#include <cmath>

#include <glm/geometric.hpp>

namespace terrella {

bool SkyView::Cone::holds(const glm::vec3& direction) const { return glm::dot(axis, direction) >= cosine; }

SkyView::SkyView(const Frame& frame) {
  const double half_angle = picture_half_angle(frame.pose, frame.view) + margin;
  picture_ = {glm::vec3(frame.pose.forward), static_cast<float>(std::cos(half_angle))};
  const auto sides = sides_of(frame.pose, frame.view, frame.rows, margin + margin_of_rows(frame));
  low_ = glm::vec3(sides[0]);
  high_ = glm::vec3(sides[1]);
  const double solid = solid_radius(frame.needs), distance = glm::length(frame.pose.eye);
  const double sine = distance > solid ? solid / distance : 0.0;
  planet_ = {glm::vec3(-frame.pose.eye / distance),
             sine > 0.0 ? static_cast<float>(std::sqrt(1.0 - sine * sine)) : 2.0F};
}

}  // namespace terrella
