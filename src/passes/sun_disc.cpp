#include "passes/sun_disc.hpp"

#include "formulas/formulas.hpp"
#include "planet/sun.hpp"

namespace terrella {
void SunDisc::draw_disc(const Frame& frame) {
  if (frame.scene.sun.size > 0.0)
    draw(frame, seen_sun_radius(frame.scene) + 2.0 * pixel_at_sun(frame.scene, frame.pose), f64::disc_brightness, 0.0);
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
  program_->set("radius", static_cast<float>(seen_sun_radius(frame.scene)));
  program_->set("pixel", static_cast<float>(pixel_at_sun(frame.scene, frame.pose)));
  program_->set("disc", static_cast<float>(disc));
  program_->set("glare", static_cast<float>(glare));
  strip_.draw(4);
}

}  // namespace terrella
