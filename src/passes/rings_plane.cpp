#include "passes/rings_plane.hpp"

#include <glm/geometric.hpp>

#include "passes/shell.hpp"

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
  const double shell = top_radius(frame.scene);
  if (glm::length(frame.pose.eye) > shell) draw_shell(spheres_, shadow_program_, frame, shadow_level, shell);
}

}  // namespace terrella
