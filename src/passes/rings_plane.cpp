#include "passes/rings_plane.hpp"

#include <vector>

#include <glm/geometric.hpp>

#include "planet/rings.hpp"

namespace terrella {
namespace {

constexpr int corners = 192;
constexpr int shadow_level = 4;

}  // namespace

void RingsPlane::draw(float side) {
  program_.use();
  program_.set("corners", static_cast<float>(corners));
  program_.set("side", side);
  strip_.draw(2 * (corners + 1));
}

void RingsPlane::draw_shadow(const Frame& frame) {
  const double shell = ring_shadow_radius(frame.scene);
  if (glm::length(frame.pose.eye) <= shell) return;
  shadow_program_.use();
  shadow_program_.set("shell", static_cast<float>(shell));
  const std::vector<float> tops(group_count, static_cast<float>(shell));
  glEnable(GL_CULL_FACE);
  spheres_.directions(shadow_level)
      .draw(visible_groups(sight_of(frame), shell * (1.0 - icosphere_sag(shadow_level)), tops));
  glDisable(GL_CULL_FACE);
}

}  // namespace terrella
