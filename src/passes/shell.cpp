#include "passes/shell.hpp"

#include <vector>

#include <glm/geometric.hpp>

namespace terrella {

void draw_shell(SphereMeshes& spheres, gl::Program& program, const Frame& frame, int level, double radius) {
  const bool above = glm::dot(frame.pose.eye, frame.pose.eye) > radius * radius;
  const double occluder = (above ? radius : 1.0) * (1.0 - icosphere_sag(level));
  const std::vector<float> tops(group_count, static_cast<float>(radius));
  program.use();
  program.set("shell", static_cast<float>(radius));
  glEnable(GL_CULL_FACE);
  glCullFace(above ? GL_BACK : GL_FRONT);
  spheres.directions(level).draw(frame, visible_groups(sight_of(frame), occluder, tops));
  glCullFace(GL_BACK);
  glDisable(GL_CULL_FACE);  // as for all veils
}

}  // namespace terrella
