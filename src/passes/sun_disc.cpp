#include "passes/sun_disc.hpp"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "formulas/formulas.hpp"
#include "planet/sun.hpp"

namespace terrella {
namespace {

double apparent_radius(const Scene& scene) { return std::tan(0.5 * glm::radians(scene.sun.size)); }

}  // namespace

void SunDisc::draw_disc(const Frame& frame) {
  const double radius = apparent_radius(frame.scene);
  if (radius > 0.0) draw(frame, radius + 2.0 * frame.pose.pixel_angle, f64::disc_brightness, 0.0);
}

void SunDisc::draw_glare(const Frame& frame) {
  const double free = free_part_of_sun(frame.scene, frame.pose, solid_radius(frame.needs));
  const double glare = free * frame.scene.sun.glare;
  if (glare > 0.0) draw(frame, f64::glare_reach, 0.0, f64::glare_brightness * glare);
}

void SunDisc::draw(const Frame& frame, double reach, double disc, double glare) {
  if (!ready_) return;
  program_->use();
  program_->set("reach", static_cast<float>(reach));
  program_->set("radius", static_cast<float>(std::max(apparent_radius(frame.scene), 0.004)));
  program_->set("disc", static_cast<float>(disc));
  program_->set("glare", static_cast<float>(glare));
  strip_.draw(4);
}

}  // namespace terrella
