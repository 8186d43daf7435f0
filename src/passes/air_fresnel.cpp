#include "passes/air_fresnel.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "formulas/formulas.hpp"
#include "planet/spheres.hpp"

namespace terrella {
namespace {

constexpr int corners = 96;

// Tangent of the angle between a sphere's centre and its limb, seen from a distance beyond its radius.
double limb_tangent(double radius, double distance) {
  return radius / f64::horizon_distance(radius, distance - radius);
}

}  // namespace

void AirFresnel::draw(const Frame& frame) {
  const double distance = glm::length(frame.pose.eye);
  const double top = air_radius(frame.scene);
  program_.use();
  // From close to the air's edge on the ring would fill the picture.
  if (distance > 1.05 * top) {
    const double widened = 1.0 / std::cos(std::numbers::pi / corners);  // its straight edges touch the circle
    program_.set("ring", static_cast<float>(limb_tangent(solid_radius(frame.needs), distance)),
                 static_cast<float>(limb_tangent(top, distance) * widened), static_cast<float>(corners), 0.0F);
    strip_.draw(2 * (corners + 1));
  } else {
    program_.set("ring", 0.0F, 0.0F, 0.0F, 0.0F);
    strip_.draw(4);
  }
}

}  // namespace terrella
